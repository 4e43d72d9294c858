#include "methods/tap_weights.h"

#include <algorithm>
#include <cmath>

#include "spectra/linear_solve.h"

namespace metamer {

namespace {

// The normal equations of one column: square * weight = pull, with the sum of the weights beside.
struct Normal {
    SquareMatrix square;
    std::vector<double> pull;
    double white;
};

Normal normal_equations(const TapProblem& p, std::span<const std::size_t> taps, std::size_t column) {
    Normal n{SquareMatrix{taps.size()}, std::vector<double>(taps.size(), 0.0), p.white[column]};
    std::vector<double> row(taps.size());
    for (std::size_t r = 0; r < p.rows; ++r) {
        const double visible = p.visible[r * p.columns + column];
        for (std::size_t j = 0; j < taps.size(); ++j)
            row[j] = visible * p.spectrum[r][taps[j]];
        for (std::size_t j = 0; j < taps.size(); ++j) {
            n.pull[j] += row[j] * visible * p.target[r * p.columns + column];
            for (std::size_t k = 0; k <= j; ++k)
                n.square(j, k) += row[j] * row[k];
        }
    }
    for (std::size_t j = 0; j < taps.size(); ++j) {
        n.square(j, j) *= 1 + kTermError * kTermError;
        for (std::size_t k = 0; k < j; ++k)
            n.square(k, j) = n.square(j, k);
    }
    return n;
}

// The solution with only the free weights, the others 0 (Lagrange: one more unknown for the sum).
std::vector<double> constrained(Normal& n, const std::vector<std::size_t>& free) {
    SquareMatrix m{free.size() + 1};
    std::vector<double> right(free.size() + 1, n.white);
    for (std::size_t j = 0; j < free.size(); ++j) {
        right[j] = n.pull[free[j]];
        m(j, free.size()) = m(free.size(), j) = 1;
        for (std::size_t k = 0; k < free.size(); ++k)
            m(j, k) = n.square(free[j], free[k]);
    }
    std::vector<double> weight(n.pull.size(), 0.0);
    const auto solved = solve(std::move(m), std::move(right));
    for (std::size_t j = 0; j < free.size(); ++j)
        weight[free[j]] = solved ? (*solved)[j] : n.white / static_cast<double>(free.size());
    return weight;
}

double error_of(const TapProblem& p, std::span<const std::size_t> taps, std::size_t column,
                const std::vector<double>& weight) {
    double sum = 0;
    for (std::size_t r = 0; r < p.rows; ++r) {
        const double visible = p.visible[r * p.columns + column];
        double off = -p.target[r * p.columns + column];
        for (std::size_t j = 0; j < taps.size(); ++j) {
            const double term = weight[j] * p.spectrum[r][taps[j]];
            off += term;
            sum += std::pow(kTermError * term * visible, 2);
        }
        sum += std::pow(off * visible, 2);
    }
    return std::sqrt(sum);
}

std::vector<std::size_t> all_of(std::size_t count) {
    std::vector<std::size_t> all(count);
    for (std::size_t i = 0; i < count; ++i)
        all[i] = i;
    return all;
}

// Towards `wanted` until the first free weight is 0, which then is free no more.
void step(std::vector<double>& weight, const std::vector<double>& wanted, std::vector<std::size_t>& free) {
    double part = 1;
    std::size_t first = free.front();
    for (const std::size_t j : free)
        if (wanted[j] <= 0 && weight[j] <= part * (weight[j] - wanted[j])) {
            part = weight[j] / (weight[j] - wanted[j]);
            first = j;
        }
    for (const std::size_t j : free)
        weight[j] += part * (wanted[j] - weight[j]);
    weight[first] = 0;
    std::erase_if(free, [&](std::size_t j) { return weight[j] <= 0; });
}

// The weight at 0 that would gain most by rising, compared with what the sum costs at the free ones; the
// count of weights when none gains.
std::size_t worth_freeing(Normal& n, const std::vector<double>& weight,
                          const std::vector<std::size_t>& free) {
    const std::size_t count = weight.size();
    std::vector<double> slope = n.pull;
    double scale = 0, price = 0;
    for (std::size_t j = 0; j < count; ++j) {
        scale = std::max(scale, std::abs(n.pull[j]));
        for (std::size_t k = 0; k < count; ++k)
            slope[j] -= n.square(j, k) * weight[k];
    }
    for (const std::size_t j : free)
        price += slope[j] / static_cast<double>(free.size());
    std::size_t best = count;
    double most = 1e-9 * scale;
    for (std::size_t j = 0; j < count; ++j)
        if (weight[j] <= 0 && slope[j] - price > most) {
            most = slope[j] - price;
            best = j;
        }
    return best;
}

} // namespace

ColumnWeights signed_weights(const TapProblem& problem, std::span<const std::size_t> taps,
                             std::size_t column) {
    Normal n = normal_equations(problem, taps, column);
    std::vector<double> weight = constrained(n, all_of(taps.size()));
    const double error = error_of(problem, taps, column, weight);
    return {std::move(weight), error};
}

ColumnWeights nonnegative_weights(const TapProblem& problem, std::span<const std::size_t> taps,
                                  std::size_t column) {
    Normal n = normal_equations(problem, taps, column);
    std::vector<std::size_t> free = all_of(taps.size());
    std::vector<double> weight(taps.size(), n.white / static_cast<double>(taps.size()));
    // Each round ends lower than the last, so that it ends; the bound is against rounding.
    for (std::size_t round = 0; round < 4 * taps.size(); ++round) {
        for (std::vector<double> wanted; !free.empty(); step(weight, wanted, free)) {
            wanted = constrained(n, free);
            if (std::all_of(free.begin(), free.end(), [&](std::size_t j) { return wanted[j] > 0; })) {
                weight = wanted;
                break;
            }
        }
        const std::size_t next = worth_freeing(n, weight, free);
        if (next == weight.size())
            break;
        free.push_back(next);
    }
    const double error = error_of(problem, taps, column, weight);
    return {std::move(weight), error};
}

} // namespace metamer
