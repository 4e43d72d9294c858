#include "atlas/row_levels.h"

#include <algorithm>

namespace metamer {

namespace {

constexpr double kFullScale = 255;

// Squared CIEDE2000 of levels whose step is 1 / 255 of `full_scale`.
double seen_error(const Levels& levels, double full_scale) {
    const double step = full_scale / kFullScale;
    return levels.error * step * step;
}

// By more than nobody sees: round-off, which differs from machine to machine, must not choose.
bool is_better(double error, double than) {
    return error < 0.999 * than - 1e-8;
}

RowValues times(double factor, const RowValues& row) {
    RowValues out;
    std::transform(row.begin(), row.end(), out.begin(), [&](double v) { return factor * v; });
    return out;
}

} // namespace

LampLevels lamp_levels(const LampPower& power) {
    const RowFit fit = fit_lamp(power);
    const auto peak = std::max_element(fit.best.begin(), fit.best.end());
    const auto at = static_cast<std::size_t>(peak - fit.best.begin());
    const LevelSearch search(fit.form);
    // Scale is free but for the peak's own rounding.
    Levels best = search.nearest(times(kFullScale / *peak, fit.best), at);
    double full = kFullScale;
    for (const double tried : {kFullScale - 0.3, kFullScale + 0.3}) {
        const Levels levels = search.nearest(times(tried / *peak, fit.best), at);
        if (is_better(seen_error(levels, *peak), seen_error(best, *peak))) {
            best = levels;
            full = tried;
        }
    }
    return {best.level, *peak * kFullScale / full};
}

MaterialLevels material_levels(const MaterialSpectrum& material, std::span<const PriorLamp> own) {
    constexpr int scales = 16;
    constexpr double headroom = 0.1, black = 1e-35; // at whose scale levels would be no numbers
    const RowFit fit = fit_material(material, own);
    const double greatest = *std::max_element(fit.best.begin(), fit.best.end());
    MaterialLevels best{{}, 1};
    if (!(greatest > black))
        return best;
    const LevelSearch search(fit.form);
    double least = 0;
    for (int n = 0; n < scales; ++n) {
        const double scale = std::min(1.0, greatest * (1 + headroom * n / scales));
        const Levels levels = search.nearest(times(kFullScale / scale, fit.best));
        const double error = seen_error(levels, scale);
        if (n == 0 || is_better(error, least)) {
            least = error;
            best = {levels.level, scale};
        }
        if (scale == 1)
            break;
    }
    return best;
}

} // namespace metamer
