#include "visit/motion.h"

#include <algorithm>
#include <cmath>

namespace metamer {

double fade(double since_s) {
    const double t = std::clamp(since_s / kFade_s, 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

Shift pixel_shift(double now_s, int most_px) {
    if (most_px <= 0)
        return {};
    // Around a square that has 0 in the middle of its upper side.
    const long side = 2L * most_px, minute = static_cast<long>(std::floor(std::max(now_s, 0.0) / 60));
    const long along = (minute + most_px) % (4 * side);
    const auto at = static_cast<int>(along % side);
    switch (along / side) {
    case 0:
        return {at - most_px, 0};
    case 1:
        return {most_px, at};
    case 2:
        return {most_px - at, 2 * most_px};
    default:
        return {-most_px, 2 * most_px - at};
    }
}

} // namespace metamer
