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
};

/// Paints a widget at its box's size. `unit_px`: Layout::unit_px; letters are given in units and shrink where
/// a text would not fit: never cut without an ellipsis, never outside the box. Colors keep a contrast of 4.5
/// to 1 (WCAG 2.1, 1.4.3); what is chosen is told by a mark and a frame besides color. Throws failure where
/// Cairo runs out of memory.
Picture paint(const Widget& widget, double unit_px);

/// The display's color of each interval of the grid (385 + 5 i nm), sRGB codes: monochromatic light, brought
/// into the space at its hue, as bright as plots can be read.
const std::vector<std::array<std::uint8_t, 3>>& wavelength_colors();

/// Relative luminance of an sRGB color and the contrast of two (WCAG 2.1).
double relative_luminance(const std::array<std::uint8_t, 3>& srgb);
double contrast(const std::array<std::uint8_t, 3>& a, const std::array<std::uint8_t, 3>& b);

/// The colors that letters and their grounds are painted in: every pair that occurs, for the test of
/// contrast.
struct InkOnGround {
    const char* where;
    std::array<std::uint8_t, 3> ink, ground;
};
std::vector<InkOnGround> inks_on_grounds();

} // namespace metamer
