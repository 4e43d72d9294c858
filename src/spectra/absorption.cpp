#include "spectra/absorption.h"

#include <algorithm>
#include <cmath>

#include "spectra/gaussian.h"

namespace metamer {

double density_at(std::span<const AbsorptionBand> bands, double wavelength_nm) {
    double sum = 0;
    for (const auto& [center_nm, fwhm_nm, density] : bands)
        sum += density * gaussian_at(wavelength_nm, center_nm, fwhm_nm);
    return sum;
}

MaterialSpectrum transmittance(std::span<const AbsorptionBand> bands) {
    std::vector<double> w;
    for (const AbsorptionBand& band : bands) {
        const std::vector<double> of_band = gaussian(band.center_nm, band.fwhm_nm).wavelength_nm;
        w.insert(w.end(), of_band.begin(), of_band.end());
    }
    std::sort(w.begin(), w.end());
    w.erase(std::unique(w.begin(), w.end()), w.end());
    Curve curve{w, {}};
    for (const double at : w)
        curve.value.push_back(std::pow(10, -density_at(bands, at)));
    return {curve};
}

} // namespace metamer
