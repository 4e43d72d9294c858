// A list of numbers in six.
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace metamer {

struct Summary {
    std::size_t count = 0;
    double mean = 0, q1 = 0, median = 0, q3 = 0, p95 = 0, max = 0;
};

/// The value below which the part `p` (0..1) of the sorted values lies: between the two values around the
/// place (n - 1) p, linearly (Hyndman and Fan 1996, definition 7). At least one value, ascending.
double quantile(std::span<const double> ascending, double p);

/// Throws bad_input `cannot summarize WHAT: ...` for no values, and for one that is not finite.
Summary summarize(std::span<const double> values, const std::string& what);

} // namespace metamer
