#include "color/spectrum.h"

#include <algorithm>

namespace metamer {

double value_at_held(const Curve& curve, double wavelength_nm) {
    const auto& w = curve.wavelength_nm;
    const auto& v = curve.value;
    if (w.empty())
        return 0;
    const auto above = std::upper_bound(w.begin(), w.end(), wavelength_nm);
    if (above == w.begin())
        return v.front();
    if (above == w.end())
        return v.back();
    const auto i = static_cast<std::size_t>(above - w.begin());
    const double t = (wavelength_nm - w[i - 1]) / (w[i] - w[i - 1]);
    return v[i - 1] + t * (v[i] - v[i - 1]);
}

Curve curve_of(const std::array<double, kIntervals>& values, double scale) {
    Curve curve;
    for (std::size_t i = 0; i < kIntervals; ++i) {
        curve.wavelength_nm.push_back(kThesisGrid.wavelength_nm(i));
        curve.value.push_back(values[i] * scale);
    }
    return curve;
}

} // namespace metamer
