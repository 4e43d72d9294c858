// Which wavelengths: greedy orthogonal matching, then exchange.
#pragma once

#include <span>
#include <vector>

#include "methods/tap_problem.h"

namespace metamer {

/// `count` of the `candidates` (indices on kReferenceGrid, ascending, at least `count`), whose spectra's
/// values combine linearly to the problem's targets with little error, all columns together: orthogonal least
/// squares (Chen, Billings, Luo 1989, Int. J. Control 50, 1873-1896) for a start, then each in turn is given
/// up for the best that could stand in its place, until none moves or kMostExchanges turns are over. A row is
/// weighed by its mean visibility, a column by its own. Ascending. Once nothing is left to gain, the rest are
/// the candidates in their order.
std::vector<std::size_t> search_taps(const TapProblem& problem, std::span<const std::size_t> candidates,
                                     std::size_t count);

/// What 10 ms for a new plan allow: six rounds of 8 taps, one and a half of 32.
inline constexpr std::size_t kMostExchanges = 48;

} // namespace metamer
