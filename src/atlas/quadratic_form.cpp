#include "atlas/quadratic_form.h"

#include <algorithm>
#include <cmath>

namespace metamer {

void QuadraticForm::add_squares(double weight, const std::array<RowValues, 3>& functions, std::size_t begin,
                                std::size_t end) {
    const auto& [a, b, c] = functions;
    for (std::size_t i = begin; i < end; ++i) {
        const double of_a = weight * a[i], of_b = weight * b[i], of_c = weight * c[i];
        // The whole row, zeros too: a length that the compiler knows is what makes it fast.
        for (std::size_t j = 0; j < kIntervals; ++j)
            g[i][j] += of_a * a[j] + of_b * b[j] + of_c * c[j];
    }
}

RowValues QuadraticForm::add_pull(double share, double floor_share) {
    double mean = 0;
    for (std::size_t i = 0; i < kIntervals; ++i)
        mean += g[i][i] / static_cast<double>(kIntervals);
    RowValues pull;
    for (std::size_t i = 0; i < kIntervals; ++i) {
        pull[i] = share * (g[i][i] + floor_share * mean);
        g[i][i] += pull[i];
    }
    return pull;
}

RowValues QuadraticForm::times(const RowValues& v) const {
    RowValues product;
    for (std::size_t i = 0; i < kIntervals; ++i) {
        double sum = 0;
        for (std::size_t j = 0; j < kIntervals; ++j)
            sum += g[i][j] * v[j];
        product[i] = sum;
    }
    return product;
}

RowValues least_within(const QuadraticForm& form, const RowValues& h, RowValues start, double low,
                       double high) {
    constexpr int most_rounds = 64;
    constexpr double still = 1e-7;
    RowValues& v = start;
    for (double& value : v)
        value = std::clamp(value, low, high);
    RowValues slope = form.times(v);
    for (std::size_t i = 0; i < kIntervals; ++i)
        slope[i] -= h[i];
    for (int round = 0; round < most_rounds; ++round) {
        double moved = 0;
        for (std::size_t i = 0; i < kIntervals; ++i) {
            const double step = std::clamp(v[i] - slope[i] / form.g[i][i], low, high) - v[i];
            if (step == 0)
                continue;
            v[i] += step;
            moved = std::max(moved, std::abs(step));
            for (std::size_t j = 0; j < kIntervals; ++j)
                slope[j] += step * form.g[i][j];
        }
        if (moved < still)
            break;
    }
    return v;
}

} // namespace metamer
