// The real-valued row that stands for a material best, and what a deviation from it costs.
#pragma once

#include <span>

#include "atlas/lamp_fit.h"

namespace metamer {

/// A lamp that materials are fitted for, Y = 1 for the perfect reflector.
struct PriorLamp {
    double weight;
    std::size_t fine_begin;
    std::vector<Xyz> fine; ///< XYZ per reflectance of each nm of kReferenceGrid, from fine_begin on
    std::size_t begin, end;
    std::array<Xyz, kIntervals> interval; ///< XYZ per reflectance of each interval; 0 outside [begin, end)
};

/// Equal energy; black bodies of 2000 .. 20000 K; Gaussian bands of standard deviation 10 and 30 nm; a line
/// every 2.5 nm, 400 .. 695 nm.
const std::vector<PriorLamp>& prior_lamps();

/// A lamp of the same atlas, whose row is this: its errors count with those of the row, so that the material
/// makes up for them. `share`: of kOwnWeight, over all of the atlas's lamps 1 in sum. The lamp must be seen.
PriorLamp own_lamp(const LampPower& power, const RowValues& row, double share);

/// What the atlas's own lamps weigh together: as much as the prior's.
inline constexpr double kOwnWeight = 20;

/// The row within 0 .. 1 whose colors under prior_lamps() and the atlas's own come nearest those at 1 nm,
/// held near the row of samples; the form, with a lighter hold, weighs deviations from it, so that the levels
/// may move further.
RowFit fit_material(const MaterialSpectrum& material, std::span<const PriorLamp> own = {});

} // namespace metamer
