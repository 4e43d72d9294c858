#include "window/rotation.h"

namespace metamer {

PxSize turned(PxSize size, int rotation_deg) {
    return rotation_deg % 180 == 0 ? size : PxSize{size.height_px, size.width_px};
}

PxPoint picture_from_surface(PxPoint point, PxSize surface, int rotation_deg) {
    return surface_from_picture(point, turned(surface, rotation_deg), (360 - rotation_deg) % 360);
}

PxPoint surface_from_picture(PxPoint point, PxSize surface, int rotation_deg) {
    switch (rotation_deg) {
    case 90: // the upper left corner goes to the upper right
        return {surface.width_px - point.y_px, point.x_px};
    case 180:
        return {surface.width_px - point.x_px, surface.height_px - point.y_px};
    case 270:
        return {point.y_px, surface.height_px - point.x_px};
    default:
        return point;
    }
}

std::array<float, 4> surface_clip_from_picture_clip(int rotation_deg) {
    // y points up here: clockwise is the negative angle.
    switch (rotation_deg) {
    case 90:
        return {0, -1, 1, 0};
    case 180:
        return {-1, 0, 0, -1};
    case 270:
        return {0, 1, -1, 0};
    default:
        return {1, 0, 0, 1};
    }
}

} // namespace metamer
