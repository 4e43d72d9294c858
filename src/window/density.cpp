#include "window/density.h"

#include <cmath>

namespace metamer {

namespace {
constexpr double kMm_per_in = 25.4;
}

double px_per_mm_of_diagonal(int width_px, int height_px, double diagonal_in) {
    return diagonal_in > 0 ? std::hypot(width_px, height_px) / (diagonal_in * kMm_per_in) : 0;
}

double px_per_mm_of_dpi(double horizontal_dpi, double vertical_dpi) {
    const double density = (horizontal_dpi + vertical_dpi) / 2 / kMm_per_in;
    // Written so that NaN is not believed either.
    const bool believable =
        density >= 1 && density <= 30 && std::abs(horizontal_dpi - vertical_dpi) <= 0.1 * vertical_dpi;
    return believable ? density : 0;
}

} // namespace metamer
