// CIE daylight.
#pragma once

#include "color/spectrum.h"
#include "color/xyz.h"

namespace metamer {

/// The correlated color temperatures for which CIE defines daylight.
inline constexpr double kLowestDaylight_k = 4000, kHighestDaylight_k = 25000;

/// Chromaticity of CIE daylight (CIE 15:2004 eq. 3.2-3.4).
Chromaticity daylight_chromaticity(double cct_k);

/// Spectral power of CIE daylight (CIE 15:2004 eq. 3.5 and 3.6, M1 and M2 rounded to three decimals as
/// there), 100 at 560 nm, 5 nm, 360 .. 830 nm. `cct_k`: kLowestDaylight_k .. kHighestDaylight_k. D50, D55,
/// D65 and D75 have the CCT 1.4388 / 1.4380 times their names'.
Curve daylight(double cct_k);

} // namespace metamer
