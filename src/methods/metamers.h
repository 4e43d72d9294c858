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
/// under `parting` in CIEDE2000. The colors that such reflectances have there fill a convex body, the metamer
/// mismatch volume (Logvinenko, Funt, Godau 2014, "Metamer mismatching", IEEE TIP 23(1)). Its opposite ends
/// are tried in 64 directions, spread evenly as the eye sees them; from the best pair each end climbs on to
/// where the difference grows the fastest, while it does. Every end is the linear program
/// max d . XYZ_parting(r), XYZ_matching(r) = xyz, 0 <= r <= 1 (color_program.h). The match is exact to 1e-10.
/// Under equal lamps there is no difference.
///
/// Such reflectances are 0 or 1 nearly everywhere; where neither lamp shines they are as beside it. `xyz`:
/// Y = 1 for the perfect reflector. Throws bad_input where no reflectance has that color under `matching`
/// (outside the object-color solid). Deterministic; takes milliseconds.
MetamericPair metameric_pair(const ReferenceLamp& matching, const ReferenceLamp& parting, const Xyz& xyz);

} // namespace metamer
