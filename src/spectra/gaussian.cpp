#include "spectra/gaussian.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace metamer {

double gaussian_at(double wavelength_nm, double center_nm, double fwhm_nm) {
    const double u = (wavelength_nm - center_nm) / fwhm_nm;
    return std::exp(-4 * std::numbers::ln2 * u * u);
}

Curve gaussian(double center_nm, double fwhm_nm) {
    constexpr int kStepsPerFwhm = 16;
    constexpr int kReach = 3 * kStepsPerFwhm; // at 3 fwhm, 7 sigma, the band is 1.5e-11
    const double first = kReferenceGrid.first_nm, last = kReferenceGrid.last_nm();
    const double step = fwhm_nm / kStepsPerFwhm;
    std::vector<double> w;
    // The band's own samples are evenly spaced, which makes the trapezoid rule exact to rounding; whole
    // nanometers would break that spacing, so they stay outside the band unless the band is the coarser.
    const bool fine = step < 1;
    for (std::size_t i = 0; i < kReferenceGrid.count; ++i)
        if (const double at = kReferenceGrid.wavelength_nm(i);
            !fine || std::abs(at - center_nm) > kReach * step + 1e-9)
            w.push_back(at);
    if (fine)
        for (int k = -kReach; k <= kReach; ++k)
            if (const double at = center_nm + k * step; at >= first && at <= last)
                w.push_back(at);
    std::sort(w.begin(), w.end());
    Curve curve{w, {}};
    std::transform(w.begin(), w.end(), std::back_inserter(curve.value),
                   [&](double at) { return gaussian_at(at, center_nm, fwhm_nm); });
    return curve;
}

} // namespace metamer
