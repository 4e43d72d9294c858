// A canvas's picture as the bytes of a file.
#pragma once

#include <functional>
#include <string>

#include "report/canvas.h"

namespace metamer {

/// What goes into the file beside the picture: for screen readers and image lists.
struct SurfaceText {
    std::string title, description;
};

/// The bytes of an SVG 1.1 file of this size. The text is outlines, so that it looks and measures the same
/// everywhere, with any font or none; title and description are there as text. The same calls give the same
/// bytes. Throws failure `cannot draw TITLE: ...` when Cairo gives up (memory, no font at all).
std::string draw_svg(int width_px, int height_px, const SurfaceText& text,
                     const std::function<void(Canvas&)>& draw);

/// The same as an opaque 8-bit sRGB PNG on white, with the text chunks Title and Description.
std::string draw_png(int width_px, int height_px, const SurfaceText& text,
                     const std::function<void(Canvas&)>& draw);

} // namespace metamer
