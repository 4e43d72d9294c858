#include "atlas/material_fit.h"

#include <algorithm>

#include "color/difference.h"
#include "color/resample.h"

namespace metamer {

namespace {

// Toward the row of samples: firm in the fit, which would else follow the prior's lamps, light for the
// levels.
constexpr double kFirmPull = 1, kLightPull = 0.01, kPullFloor = 1e-4;

FineValues fine_reflectance(const MaterialSpectrum& material) {
    FineValues fine;
    const std::vector<double> values = resample(material, kReferenceGrid);
    std::transform(values.begin(), values.end(), fine.begin(),
                   [](double v) { return std::clamp(v, 0.0, 1.0); });
    return fine;
}

// Adds one lamp's squared error, J (sum over the row - XYZ at 1 nm), to v' G v - 2 h' v.
void add_lamp_error(QuadraticForm& form, RowValues& h, const PriorLamp& lamp, const FineValues& fine) {
    Xyz xyz;
    for (std::size_t n = 0; n < lamp.fine.size(); ++n)
        xyz = xyz + fine[lamp.fine_begin + n] * lamp.fine[n];
    const Matrix3 slopes = delta_e_2000_slopes(xyz);
    const auto target = slopes * std::array{xyz.x, xyz.y, xyz.z};
    std::array<RowValues, 3> a{};
    for (std::size_t i = lamp.begin; i < lamp.end; ++i) {
        const Xyz& part = lamp.interval[i];
        const auto seen = slopes * std::array{part.x, part.y, part.z};
        for (std::size_t c = 0; c < 3; ++c) {
            a[c][i] = seen[c];
            h[i] += lamp.weight * seen[c] * target[c];
        }
    }
    form.add_squares(lamp.weight, a, lamp.begin, lamp.end);
}

} // namespace

RowFit fit_material(const MaterialSpectrum& material, std::span<const PriorLamp> own) {
    const FineValues fine = fine_reflectance(material);
    RowValues start = sample_material(material).value;
    const RowValues folded = projected(fine);
    start.front() = folded.front();
    start.back() = folded.back();
    RowFit fit;
    RowValues h{};
    for (const PriorLamp& lamp : prior_lamps())
        add_lamp_error(fit.form, h, lamp, fine);
    QuadraticForm firm = fit.form;
    const RowValues pull = firm.add_pull(kFirmPull, kPullFloor);
    for (std::size_t i = 0; i < kIntervals; ++i)
        h[i] += pull[i] * start[i];
    fit.form.add_pull(kLightPull, kPullFloor);
    // Lamps that are known for certain pull harder than the row of samples holds.
    RowValues own_h{};
    for (const PriorLamp& lamp : own) {
        RowValues same{};
        add_lamp_error(firm, own_h, lamp, fine);
        add_lamp_error(fit.form, same, lamp, fine);
    }
    for (std::size_t i = 0; i < kIntervals; ++i)
        h[i] += own_h[i];
    fit.best = least_within(firm, h, start, 0, 1);
    return fit;
}

} // namespace metamer
