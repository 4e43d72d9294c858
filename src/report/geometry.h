// Points and boxes on a picture, px; y grows downward.
#pragma once

#include <algorithm>

namespace metamer {

struct Px {
    double x = 0, y = 0;
};

/// An upright rectangle; left <= right and top <= bottom.
struct Box {
    double left = 0, top = 0, right = 0, bottom = 0;

    double width() const { return right - left; }
    double height() const { return bottom - top; }
    Px center() const { return {(left + right) / 2, (top + bottom) / 2}; }
};

/// Whether the insides meet; boxes that only touch do not.
inline bool overlap(const Box& a, const Box& b) {
    return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

/// The area that both cover, px².
inline double shared_area(const Box& a, const Box& b) {
    const double width = std::min(a.right, b.right) - std::max(a.left, b.left);
    const double height = std::min(a.bottom, b.bottom) - std::max(a.top, b.top);
    return width > 0 && height > 0 ? width * height : 0;
}

inline bool inside(const Box& inner, const Box& outer) {
    return inner.left >= outer.left && inner.right <= outer.right && inner.top >= outer.top &&
           inner.bottom <= outer.bottom;
}

inline Box grown(const Box& box, double by) {
    return {box.left - by, box.top - by, box.right + by, box.bottom + by};
}

inline Box around(Px center, double radius) {
    return {center.x - radius, center.y - radius, center.x + radius, center.y + radius};
}

/// The point of the box that is nearest to `p`; `p` itself inside.
inline Px nearest_point(const Box& box, Px p) {
    return {std::clamp(p.x, box.left, box.right), std::clamp(p.y, box.top, box.bottom)};
}

/// Whether the segment from `a` to `b` meets the inside of the box (Liang and Barsky 1984).
bool crosses(const Box& box, Px a, Px b);

} // namespace metamer
