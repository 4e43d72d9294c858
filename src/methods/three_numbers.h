// The three numbers that the product methods know of a lamp and of a material, summed on the CPU from the
// same atlas rows that the spectral loop reads.
#pragma once

#include "color/observer.h"
#include "color/spectrum.h"
#include "color/working_space.h"
#include "color/xyz.h"

namespace metamer {

/// k' of equation 7.9 on the grid: the sum of S y.
double grid_k(const Emission& lamp, const GridObserver& observer);

/// What method `packed` multiplies a lamp's sums with: strength / k', 0 for a lamp of k' = 0.
double packed_scale(const Emission& lamp, double strength, const GridObserver& observer);

/// XYZ of a material under a lamp on the grid, Y = 1 for the perfect reflector: equations 7.1, 7.6-7.10 in
/// double; 0 for a lamp of k' = 0.
Xyz grid_xyz(const Emission& lamp, const Reflectance& material, const GridObserver& observer);

/// The lamp's three numbers: XYZ with R = 1.
Xyz lamp_xyz(const Emission& lamp, const GridObserver& observer);

/// The material's three numbers for `tristimulus`: XYZ under equal energy, S = 1.
Xyz material_xyz(const Reflectance& material, const GridObserver& observer);

/// The illuminant of a working space's white (D65, D50, E or C of the library) on the grid. `rgb` takes a
/// material's three numbers under it, grid_xyz(white_emission(space), ...): the way colors of materials are
/// published and picked.
const Emission& white_emission(const WorkingSpace& space);

} // namespace metamer
