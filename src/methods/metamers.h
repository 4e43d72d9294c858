// Metameric pairs: two reflectances of the same color under one lamp, as different as physics allows under
// another.
#pragma once

#include "color/colorimetry.h"
#include "color/spectrum.h"
#include "color/xyz.h"

namespace metamer {

struct MetamericPair {
    MaterialSpectrum a, b; ///< 0 .. 1, on the grid of kReferenceGrid
    Xyz under_matching;    ///< of both, Y = 1 for the perfect reflector
    Xyz a_under_parting, b_under_parting;
    double delta_e_2000; ///< of the last two
};

/// Of all pairs of reflectances that both have the color `xyz` under `matching`, one that differs the most
/// under `parting` in CIEDE2000: opposite points of the metamer mismatch volume (Logvinenko, Funt, Godau
/// 2014, "Metamer mismatching", IEEE TIP 23(1)), found over `directions` directions of XYZ spread evenly over
/// the sphere. Each end is the linear program max d . XYZ_parting(r), XYZ_matching(r) = xyz, 0 <= r <= 1,
/// solved through its dual of three unknowns. `smoothness` > 0 leaves the bounds softly (logistic instead of
/// steps, in shares of the greatest weight): smoother spectra, a little less difference; the match stays
/// exact. Throws bad_input where no reflectance has that color under `matching` (outside the object-color
/// solid).
MetamericPair metameric_pair(const ReferenceLamp& matching, const ReferenceLamp& parting, const Xyz& xyz,
                             double smoothness = 0, int directions = 64);

} // namespace metamer
