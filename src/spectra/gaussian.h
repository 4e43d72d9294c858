// Gaussian bands.
#pragma once

#include "color/spectrum.h"

namespace metamer {

/// What gaussian() takes.
inline constexpr double kNarrowest_nm = 0.1, kWidest_nm = 500;

/// exp(-4 ln 2 ((w - center) / fwhm)^2), peak 1 and half of it at center +- fwhm / 2, over 360 .. 830 nm:
/// every nm, and about the center fine enough (fwhm / 16) that its energy is fwhm sqrt(pi / (4 ln 2)) to 1e-9
/// where the band lies inside. `center_nm`: 360 .. 830; `fwhm_nm`: kNarrowest_nm .. kWidest_nm.
Curve gaussian(double center_nm, double fwhm_nm);

/// Its value at one wavelength.
double gaussian_at(double wavelength_nm, double center_nm, double fwhm_nm);

} // namespace metamer
