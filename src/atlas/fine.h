// Spectra at 1 nm against the rows that stand for them.
#pragma once

#include <array>

#include "atlas/quadratic_form.h"
#include "color/observer.h"
#include "color/xyz.h"

namespace metamer {

/// Values on kReferenceGrid: a lamp's power per nm, or a reflectance.
using FineValues = std::array<double, kReferenceGrid.count>;

/// weighted_observer() by interval, made once.
const std::array<Xyz, kIntervals>& interval_weights();

/// The row that keeps each interval's own share of X, Y and Z, as far as one number can: the least-squares
/// multiple of the interval's weights. A spectrum that is linear over an interval passes unchanged.
RowValues projected(const FineValues& fine);

/// Sum of `row` times the weights: X', Y', Z' of equations 7.6-7.8 in the weights' unit.
Xyz weighted_sum(const RowValues& row);

/// Component by component a / b; 1 where b is 0.
Xyz ratio(const Xyz& a, const Xyz& b);

/// X', Y', Z' of power times reflectance at 1 nm.
Xyz fine_sum(const FineValues& power, const FineValues& reflectance);

} // namespace metamer
