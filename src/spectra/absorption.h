// Absorbing media: internal transmittance from bands of optical density.
#pragma once

#include <span>

#include "color/spectrum.h"

namespace metamer {

/// A Gaussian band of optical density: `density` (decadic) at its center, half of it at center +- fwhm / 2.
struct AbsorptionBand {
    double center_nm, fwhm_nm, density;
};

/// What a band's density may be: 0 .. kDensest.
inline constexpr double kDensest = 10;

/// Internal transmittance at thickness 1: 10^(-D), D the sum of the bands (Lambert-Beer law: densities add),
/// over 360 .. 830 nm, every nm and finer where a band is. At thickness d it is this to the power d; surfaces
/// reflect nothing. `bands`: centers and widths as gaussian() takes them.
MaterialSpectrum transmittance(std::span<const AbsorptionBand> bands);

/// The sum of the bands' densities at a wavelength.
double density_at(std::span<const AbsorptionBand> bands, double wavelength_nm);

} // namespace metamer
