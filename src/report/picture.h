// A picture of plots as a file.
#pragma once

#include <filesystem>
#include <string>

#include "report/plot.h"

namespace metamer {

/// The bytes of an SVG file (text as outlines), the same for the same picture. Throws bad_input `cannot draw
/// TITLE: ...` for a size outside 320x240 .. 4096x4096, columns below 1, panels too small to hold a plot, a
/// point without an x; what axis.h says of axes; failure when Cairo gives up.
std::string picture_svg(const Picture& picture);

/// The same as an 8-bit sRGB PNG.
std::string picture_png(const Picture& picture);

/// The number of labels of series, marks, lines and regions for which the picture has no room; it says so in
/// its corner. Throws as above.
int unplaced_labels(const Picture& picture);

/// Writes the picture as its name's ending says, whole or not at all. Throws as above and as write_file does,
/// and bad_input `cannot write FILE: a picture ends in .svg or .png`.
void write_picture(const std::filesystem::path& path, const Picture& picture);

} // namespace metamer
