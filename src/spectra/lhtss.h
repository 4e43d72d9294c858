// The smoothest reflectance of a given color.
#pragma once

#include <optional>

#include "color/spectrum.h"
#include "color/xyz.h"

namespace metamer {

/// The reflectance with the least hyperbolic tangent slope squared (LHTSS; S. A. Burns, "Numerical methods
/// for smoothest reflectance reconstruction", Color Research and Application 45 (2020) 8-21, and
/// scottburns.us): rho = (tanh z + 1) / 2 on 380 .. 780 nm every 5 nm, its ends held beyond, with the least
/// sum of (z[i+1] - z[i])^2 among those whose reference_xyz under the library's D65 is `target` (to 1e-10, Y
/// = 1 for the perfect reflector). 0 < rho < 1 everywhere.
///
/// Lagrange's conditions are solved by Newton's method, starting from the gray of the target's Y and moving
/// the target in steps as great as converge. None when they end before the target: no reflectance in 0 .. 1
/// has that color, or only one that touches 0 or 1 to rounding.
std::optional<MaterialSpectrum> lhtss(const Xyz& target);

} // namespace metamer
