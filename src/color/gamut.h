// What becomes of colors that a working space does not hold.
#pragma once

#include <algorithm>

#include "color/xyz.h"

namespace metamer {

/// `clip`: each component to 0 .. 1 by itself, which turns hues. `keep_hue`: towards the gray of the same
/// light until no component is negative, then all together down to 1.
enum class Gamut { clip, keep_hue };

/// The gray that negative components are mixed with: the mean of the three, as luminance weights differ from
/// space to space. A color of no light at all stays black.
template <class T>
BasicLinearRgb<T> kept_hue(const BasicLinearRgb<T>& c) {
    const T gray = std::max(static_cast<T>((c.r + c.g + c.b) / T(3)), T(0));
    const T least = std::min({c.r, c.g, c.b, T(0)});
    const T most = std::max({c.r, c.g, c.b, T(1)});
    // gray + t (c - gray) is 0 where c is least.
    const T t = gray > T(0) ? static_cast<T>(gray / (gray - least)) : T(0);
    const T peak = std::max(static_cast<T>(gray + t * (most - gray)), T(1));
    const auto moved = [&](T v) { return static_cast<T>((gray + t * (v - gray)) / peak); };
    return {moved(c.r), moved(c.g), moved(c.b)};
}

/// Whether the working space holds a color's hue: no component is below -`slack`.
constexpr bool in_gamut(const LinearRgb& c, double slack = 1e-6) {
    return c.r >= -slack && c.g >= -slack && c.b >= -slack;
}

} // namespace metamer
