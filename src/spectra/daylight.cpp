#include "spectra/daylight.h"

#include <algorithm>
#include <cmath>

#include "spectra/tables.h"

namespace metamer {

namespace {
double three_decimals(double v) {
    return std::round(v * 1000) / 1000;
}
} // namespace

Chromaticity daylight_chromaticity(double cct_k) {
    const double t = 1000 / cct_k;
    const double x = cct_k <= 7000 ? -4.6070 * t * t * t + 2.9678 * t * t + 0.09911 * t + 0.244063
                                   : -2.0064 * t * t * t + 1.9018 * t * t + 0.24748 * t + 0.237040;
    return {x, -3.000 * x * x + 2.870 * x - 0.275};
}

Curve daylight(double cct_k) {
    const auto [x, y] = daylight_chromaticity(cct_k);
    const double m = 0.0241 + 0.2562 * x - 0.7341 * y;
    const double m1 = three_decimals((-1.3515 - 1.7703 * x + 5.9114 * y) / m);
    const double m2 = three_decimals((0.0300 - 31.4424 * x + 30.0717 * y) / m);
    const Curve& s0 = column(daylight_components(), "S0");
    const Curve& s1 = column(daylight_components(), "S1");
    const Curve& s2 = column(daylight_components(), "S2");
    Curve curve;
    for (std::size_t i = 0; i < s0.value.size(); ++i) {
        const double w = s0.wavelength_nm[i];
        if (w < kReferenceGrid.first_nm || w > kReferenceGrid.last_nm())
            continue;
        curve.wavelength_nm.push_back(w);
        // Near 25000 K the sum would stay positive over this range; the bound guards against rounding only.
        curve.value.push_back(std::max(0.0, s0.value[i] + m1 * s1.value[i] + m2 * s2.value[i]));
    }
    return curve;
}

} // namespace metamer
