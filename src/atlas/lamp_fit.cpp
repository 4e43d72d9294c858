#include "atlas/lamp_fit.h"

#include <algorithm>

#include "color/difference.h"
#include "color/resample.h"

namespace metamer {

namespace {

constexpr double kPull = 0.01, kPullFloor = 1e-4; // toward the row of samples, where the prior says nothing
constexpr double kMostPower = 1e300;

// The error of one reflectance: J (X' - k' x, ...) / k', as three linear functions of the row.
void add_reflectance(QuadraticForm& form, const PriorMaterial& material, const Xyz& xyz, double k) {
    const auto& weights = interval_weights();
    const Matrix3 slopes = delta_e_2000_slopes(xyz);
    std::array<RowValues, 3> a;
    for (std::size_t i = 0; i < kIntervals; ++i) {
        const double r = material.row[i], y = weights[i].y;
        const auto seen = slopes * std::array{(weights[i].x * r - xyz.x * y) / k, (y * r - xyz.y * y) / k,
                                              (weights[i].z * r - xyz.z * y) / k};
        for (std::size_t c = 0; c < 3; ++c)
            a[c][i] = seen[c];
    }
    form.add_squares(material.weight, a);
}

// A lamp has no light two intervals from its own, even where a level there would balance a sum.
void keep_dark(QuadraticForm& form, const RowValues& start) {
    constexpr double prohibitive = 1e6;
    for (std::size_t i = 0; i < kIntervals; ++i) {
        const double before = i > 0 ? start[i - 1] : 0, after = i + 1 < kIntervals ? start[i + 1] : 0;
        if (before == 0 && start[i] == 0 && after == 0)
            form.g[i][i] *= prohibitive;
    }
}

} // namespace

LampPower lamp_power(const LampSpectrum& lamp) {
    LampPower power;
    const std::vector<double> fine = resample(lamp, kReferenceGrid), row = resample(lamp, kThesisGrid);
    std::copy(fine.begin(), fine.end(), power.fine.begin());
    std::copy(row.begin(), row.end(), power.row.begin());
    return power;
}

bool is_seen(const LampPower& power) {
    return fine_sum(power.fine, prior_materials().front().fine).y > 0; // white
}

RowFit fit_lamp(const LampPower& power) {
    RowValues start = power.row;
    const RowValues folded = projected(power.fine);
    start.front() = folded.front();
    start.back() = folded.back();
    RowFit fit;
    const double k = weighted_sum(start).y;
    const double fine_k = fine_sum(power.fine, prior_materials().front().fine).y; // white
    for (const PriorMaterial& material : prior_materials()) {
        const Xyz xyz = (1 / fine_k) * fine_sum(power.fine, material.fine), &error = material.row_error;
        add_reflectance(fit.form, material, {xyz.x * error.x, xyz.y * error.y, xyz.z * error.z}, k);
    }
    RowValues pull = fit.form.add_pull(kPull, kPullFloor);
    keep_dark(fit.form, start);
    for (std::size_t i = 0; i < kIntervals; ++i)
        pull[i] *= start[i];
    fit.best = least_within(fit.form, pull, start, 0, kMostPower);
    return fit;
}

} // namespace metamer
