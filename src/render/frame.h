// One frame of an exhibit as a picture.
#pragma once

#include <string>

#include "exhibit/exhibit.h"
#include "gles/framebuffer.h"
#include "image/png.h"

namespace metamer {

/// The color buffer that stands for a display of this color depth.
ColorBuffer color_buffer_of(const Display& display);

/// A framebuffer of the display's size and color depth, its pixels `supersample` squared as many. Needs a
/// current context; throws what Framebuffer throws.
Framebuffer framebuffer_of(const Display& display);

/// Draws the exhibit at its display's size into a framebuffer of its own and reads it back. Needs a current
/// ES 2 context. Throws failure where GL refuses, bad_input for what the exhibit asks and cannot be
/// (adaptation).
Image render_frame(const Exhibit& exhibit);

/// XYZ of the linear RGB that a display of this working space or own matrix shows.
Matrix3 xyz_from_display_rgb(const Display& display);

/// What a PNG of this exhibit says of its colors: the sRGB chunk for sRGB-D65 with the sRGB curve, else gAMA
/// and the primaries and white of its space or own matrix (no cHRM where those are no chromaticities).
ColorChunks color_chunks(const Display& display);

/// The frame as PNG bytes, with color chunks and a text chunk that names the exhibit.
std::string encode_frame(const Image& image, const Exhibit& exhibit);

} // namespace metamer
