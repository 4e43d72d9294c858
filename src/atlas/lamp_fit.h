// The real-valued row that stands for a lamp best, and what a deviation from it costs.
#pragma once

#include <vector>

#include "atlas/fine.h"
#include "color/spectrum.h"

namespace metamer {

/// A fit of a row: `best` and the form whose value at (v - best) is, but for a constant, the squared
/// CIEDE2000 of a row v, summed over a prior.
struct RowFit {
    RowValues best;
    QuadraticForm form;
};

/// Power per nm, at 1 nm (resample()) and on the grid's wavelengths.
struct LampPower {
    FineValues fine;
    RowValues row;
};
LampPower lamp_power(const LampSpectrum& lamp);

/// Whether the observer sees any of it: its k' at 1 nm is above 0.
bool is_seen(const LampPower& power);

/// The emission, in the unit of `power` and at least 0, whose colors of prior_materials() come nearest those
/// at 1 nm; k' goes with it, so that scale does not matter. The errors are those of X', Y', Z' less k' times
/// XYZ at 1 nm, seen as delta_e_2000_slopes() says there. The lamp must be seen.
RowFit fit_lamp(const LampPower& power);

/// A reflectance that lamps are fitted for, 0 .. 1, and its row. All are by formula, none measured: what
/// holds for them holds for spectra never seen.
struct PriorMaterial {
    FineValues fine;
    RowValues row;
    Xyz row_error; ///< XYZ of the row over XYZ at 1 nm under equal energy: the material's own error, no
                   ///< lamp's
    double weight;
};

/// White; Gaussian bands on black and notches in white, edges rising and falling, ripples of 40 .. 170 nm.
const std::vector<PriorMaterial>& prior_materials();

} // namespace metamer
