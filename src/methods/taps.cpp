#include "methods/taps.h"

#include <algorithm>
#include <cmath>

#include "color/observer.h"
#include "methods/tap_problem.h"
#include "methods/tap_search.h"
#include "methods/tap_weights.h"

namespace metamer {

namespace {

// A wavelength with less than this share of the lamps' X + Y + Z is no candidate as long as others are.
constexpr double kFaint = 1e-6;

Xyz response(const ReferenceLamp& lamp, std::size_t i) {
    const ColorMatching& eye = cie_1931_2deg()[i];
    return (lamp.power[i] / lamp.k) * Xyz{eye.x, eye.y, eye.z};
}

// X + Y + Z of all lamps, by wavelength.
std::vector<double> light_seen(std::span<const ReferenceLamp* const> lamps) {
    std::vector<double> seen(kReferenceGrid.count, 0.0);
    for (const ReferenceLamp* lamp : lamps)
        for (std::size_t i = 0; i < seen.size(); ++i) {
            const Xyz c = response(*lamp, i);
            seen[i] += c.x + c.y + c.z;
        }
    return seen;
}

std::vector<std::size_t> brighter_than(const std::vector<double>& seen, double least) {
    std::vector<std::size_t> out;
    for (std::size_t i = 0; i < seen.size(); ++i)
        if (seen[i] > least)
            out.push_back(i);
    return out;
}

// No more lines than taps: the integral is a sum over the lines. The rest of the taps are dark wavelengths.
std::vector<std::size_t> filled_up(std::vector<std::size_t> lit, std::size_t count) {
    for (std::size_t i = 0; lit.size() < count; ++i)
        if (std::find(lit.begin(), lit.end(), i) == lit.end())
            lit.push_back(i);
    std::sort(lit.begin(), lit.end());
    return lit;
}

std::vector<Xyz> weights_of_lines(const ReferenceLamp& lamp, const std::vector<std::size_t>& taps) {
    std::vector<Xyz> weight;
    for (const std::size_t i : taps)
        weight.push_back(response(lamp, i));
    return weight;
}

std::vector<double> fitted(const TapProblem& problem, const std::vector<std::size_t>& taps,
                           std::size_t column, bool has_own) {
    ColumnWeights plain = nonnegative_weights(problem, taps, column);
    if (!has_own || plain.error <= kWorthNegative)
        return plain.weight;
    ColumnWeights both = signed_weights(problem, taps, column);
    return both.error < plain.error - kWorthNegative ? both.weight : plain.weight;
}

Taps fit(std::span<const ReferenceLamp* const> lamps, std::span<const std::vector<double>> own,
         const std::vector<double>& seen, std::size_t count) {
    double total = 0;
    for (const double s : seen)
        total += s;
    std::vector<std::size_t> candidates = brighter_than(seen, kFaint * total);
    if (candidates.size() < count)
        candidates = brighter_than(seen, 0);
    const TapProblem problem = tap_problem(lamps, own);
    const std::vector<std::size_t> taps = search_taps(problem, candidates, count);
    Taps out;
    for (const std::size_t i : taps)
        out.wavelength_nm.push_back(kReferenceGrid.wavelength_nm(i));
    out.weight.assign(lamps.size(), std::vector<Xyz>(count));
    for (std::size_t l = 0; l < lamps.size(); ++l) {
        const auto x = fitted(problem, taps, 3 * l, !own.empty()),
                   y = fitted(problem, taps, 3 * l + 1, !own.empty()),
                   z = fitted(problem, taps, 3 * l + 2, !own.empty());
        for (std::size_t j = 0; j < count; ++j)
            out.weight[l][j] = {x[j], y[j], z[j]};
    }
    return out;
}

} // namespace

Taps choose_taps(std::span<const ReferenceLamp* const> lamps, std::span<const std::vector<double>> own,
                 int count) {
    const std::vector<double> seen = light_seen(lamps);
    const std::vector<std::size_t> lit = brighter_than(seen, 0);
    const auto wanted = static_cast<std::size_t>(count);
    if (lit.size() > wanted)
        return fit(lamps, own, seen, wanted);
    const std::vector<std::size_t> taps = filled_up(lit, wanted);
    Taps out;
    for (const std::size_t i : taps)
        out.wavelength_nm.push_back(kReferenceGrid.wavelength_nm(i));
    for (const ReferenceLamp* lamp : lamps)
        out.weight.push_back(weights_of_lines(*lamp, taps));
    return out;
}

Taps of_lamps(const Taps& taps, std::span<const std::size_t> lamps) {
    Taps out{taps.wavelength_nm, {}};
    for (const std::size_t l : lamps)
        out.weight.push_back(taps.weight[l]);
    return out;
}

Xyz taps_xyz(const Taps& taps, std::size_t lamp, std::span<const double> light) {
    Xyz sum;
    for (std::size_t j = 0; j < taps.wavelength_nm.size(); ++j) {
        const double at = (taps.wavelength_nm[j] - kReferenceGrid.first_nm) / kReferenceGrid.step_nm;
        sum = sum + light[static_cast<std::size_t>(std::lround(at))] * taps.weight[lamp][j];
    }
    return sum;
}

} // namespace metamer
