// Squared errors of a row's sums, as a quadratic form over its 64 values.
#pragma once

#include <array>
#include <cstddef>

#include "color/grid.h"

namespace metamer {

/// 64 values of a row, in whatever unit its user says.
using RowValues = std::array<double, kIntervals>;

/// E(v) = v' G v, G symmetric and positive semidefinite.
struct QuadraticForm {
    std::array<RowValues, kIntervals> g{};

    /// Adds weight * sum over the three functions of (sum of a v)^2; they are 0 outside [begin, end).
    void add_squares(double weight, const std::array<RowValues, 3>& functions, std::size_t begin = 0,
                     std::size_t end = kIntervals);

    /// Adds share * G_ii + share * floor_share * (mean of the diagonal) to each diagonal element, and returns
    /// what was added: a pull toward a row that is known to be near the best one.
    RowValues add_pull(double share, double floor_share);

    /// G v.
    RowValues times(const RowValues& v) const;
};

/// The v within low .. high that minimizes v' G v - 2 h' v, by coordinate descent from `start` (64 rounds at
/// most: a start that is near is assumed). G must have a positive diagonal.
RowValues least_within(const QuadraticForm& form, const RowValues& h, RowValues start, double low,
                       double high);

} // namespace metamer
