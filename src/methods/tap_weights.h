// How much each wavelength weighs.
#pragma once

#include <span>
#include <vector>

#include "methods/tap_problem.h"

namespace metamer {

/// What a term weight * f(wavelength) is off by when a GPU computes it, as a share of itself: in half
/// precision T^d = exp2(d log2 T) has an exponent with a last place of 2^-7 at density 3, so that a term is
/// off by 0.3 %.
inline constexpr double kTermError = 0.003;

/// A column's weights for the wavelengths at `taps` (indices on kReferenceGrid), and their expected error:
/// the root of the weighted sum of squares over the problem's rows, each of its terms off by kTermError at
/// random. That also keeps the weights small where two taps see nearly the same.
struct ColumnWeights {
    std::vector<double> weight;
    double error;
};

/// The weights of least error whose sum is the column's white.
ColumnWeights signed_weights(const TapProblem& problem, std::span<const std::size_t> taps,
                             std::size_t column);

/// The same among non-negative weights: Lawson and Hanson's active set (Solving Least Squares Problems, 1974,
/// ch. 23) with the sum as an equation beside.
ColumnWeights nonnegative_weights(const TapProblem& problem, std::span<const std::size_t> taps,
                                  std::size_t column);

} // namespace metamer
