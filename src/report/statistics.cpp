#include "report/statistics.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/error.h"
#include "base/numbers.h"

namespace metamer {

double quantile(std::span<const double> ascending, double p) {
    const double place = p * static_cast<double>(ascending.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const auto above = std::min(below + 1, ascending.size() - 1);
    return std::lerp(ascending[below], ascending[above], place - std::floor(place));
}

Summary summarize(std::span<const double> values, const std::string& what) {
    if (values.empty())
        throw bad_input("summarize", what, "there are no values");
    std::vector<double> sorted(values.begin(), values.end());
    for (const double value : sorted)
        if (!std::isfinite(value))
            throw bad_input("summarize", what, "a value is " + to_text(value));
    std::sort(sorted.begin(), sorted.end());
    const auto count = static_cast<double>(sorted.size());
    double mean = 0;
    for (const double value : sorted)
        mean += value / count; // no overflow on the way
    return {.count = sorted.size(),
            .mean = mean,
            .q1 = quantile(sorted, 0.25),
            .median = quantile(sorted, 0.5),
            .q3 = quantile(sorted, 0.75),
            .p95 = quantile(sorted, 0.95),
            .max = sorted.back()};
}

} // namespace metamer
