// A picture that stands turned on its surface: portrait on a landscape display, or upside down.
#pragma once

#include <array>

namespace metamer {

/// From the upper left corner; a pixel's center is at .5.
struct PxPoint {
    double x_px = 0, y_px = 0;
};

struct PxSize {
    int width_px = 0, height_px = 0;
    bool operator==(const PxSize&) const = default;
};

/// Everywhere here: `surface` is what the display has, the picture is what people see, turned clockwise on it
/// by `rotation_deg`: 0, 90, 180 or 270. Coordinates are continuous and exact.

/// The picture's size for a surface, and the surface's for a picture.
PxSize turned(PxSize size, int rotation_deg);

PxPoint picture_from_surface(PxPoint point, PxSize surface, int rotation_deg);
PxPoint surface_from_picture(PxPoint point, PxSize surface, int rotation_deg);

/// The surface's clip coordinates from the picture's (x right, y up, -1 .. 1): a mat2 as
/// glUniformMatrix2fv takes it, column by column; elements are 0, 1 and -1.
std::array<float, 4> surface_clip_from_picture_clip(int rotation_deg);

} // namespace metamer
