#include <algorithm>
#include <cmath>

#include "atlas/row_levels.h"
#include "color/observer.h"

namespace metamer {

namespace {

std::array<std::uint8_t, kIntervals> diffused(const std::array<double, kIntervals>& values) {
    std::array<std::uint8_t, kIntervals> levels;
    double handed_on = 0;
    for (std::size_t i = 0; i < kIntervals; ++i) {
        const double wanted = 255 * values[i] + handed_on;
        const double level = std::clamp(std::floor(wanted + 0.5), 0.0, 255.0);
        handed_on = wanted - level;
        levels[i] = static_cast<std::uint8_t>(level);
    }
    return levels;
}

} // namespace

std::array<std::array<std::uint8_t, kIntervals>, 3> observer_levels() {
    const GridObserver exact = weighted_observer();
    return {diffused(exact.x), diffused(exact.y), diffused(exact.z)};
}

} // namespace metamer
