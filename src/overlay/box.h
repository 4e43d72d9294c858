// Places on the screen, px from the upper left corner.
#pragma once

namespace metamer {

/// Whole pixels: what is painted once and shown unscaled stays sharp.
struct PxBox {
    int left = 0, top = 0, width = 0, height = 0;

    int right() const { return left + width; }
    int bottom() const { return top + height; }
    bool contains(double x, double y) const { return x >= left && x < right() && y >= top && y < bottom(); }
    bool operator==(const PxBox&) const = default;
};

} // namespace metamer
