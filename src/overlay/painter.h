// Widgets as pictures, by Pango and Cairo.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "overlay/widget.h"

namespace metamer {

/// RGBA8, premultiplied, rows from the top.
struct Picture {
    int width_px = 0, height_px = 0;
    std::vector<std::uint8_t> rgba;
    bool text_cut = false; ///< a text did not fit even in the smallest letters and ends in an ellipsis
};

/// Paints a widget at its box's size. `unit_px`: Layout::unit_px; letters are given in units and shrink where
/// a text would not fit: never cut without an ellipsis, never outside the box. Colors keep a contrast of 4.5
/// to 1 (WCAG 2.1, 1.4.3); what is chosen is told by a mark and a frame besides color. Plots have short
/// wavelengths on the left, whatever the language. Throws failure where Cairo runs out of memory.
Picture paint(const Widget& widget, double unit_px);

} // namespace metamer
