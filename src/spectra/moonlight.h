// A model of moonlight.
#pragma once

#include "color/spectrum.h"

namespace metamer {

/// The Moon's reddening as the exponent of a power law in wavelength: the full Moon's B-V is 0.92 (Cox,
/// Allen's Astrophysical Quantities, 4th ed., Table 12.14), the Sun's 0.65, so its albedo at B (442 nm) is
/// 10^(-0.4 * 0.27) of that at V (550 nm), and ln 10^(-0.108) / ln (442 / 550) = 1.14.
inline constexpr double kLunarReddening = 1.14;

/// Moonlight at the ground, modelled, not measured: CIE D55 (sunlight at the ground) times (w / 560
/// nm)^kLunarReddening, 100 at 560 nm, 5 nm, 380 .. 780 nm.
Curve moonlight();

} // namespace metamer
