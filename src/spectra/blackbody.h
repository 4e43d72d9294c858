// Planck's law.
#pragma once

#include "color/spectrum.h"

namespace metamer {

/// The second radiation constant h c / k of the 2019 SI (CODATA 2018), in nm K. CIE A is defined with an
/// older one: take A from the table.
inline constexpr double kSecondRadiation_nm_k = 1.438776877e7;

/// Temperatures that blackbody() takes: below, the light of 360 nm drowns in rounding beside that of 830 nm.
inline constexpr double kColdestBlackbody_k = 500, kHottestBlackbody_k = 100000;

/// Spectral radiant exitance of a black body (Planck's law, CIE 15:2018 eq. 4.1), 100 at 560 nm, every nm of
/// kReferenceGrid. `temperature_k`: kColdestBlackbody_k .. kHottestBlackbody_k.
Curve blackbody(double temperature_k);

} // namespace metamer
