#include "methods/tap_problem.h"

#include <cmath>
#include <numbers>

#include "color/difference.h"

namespace metamer {

namespace {

constexpr double kGray = 0.25;

// CIEDE2000 per unit of X, of Y, of Z at this color.
std::array<double, 3> visibility(const Xyz& color) {
    const Matrix3 slopes = delta_e_2000_slopes(color);
    const auto& m = slopes.m;
    return {std::hypot(m[0][0], m[1][0], m[2][0]), std::hypot(m[0][1], m[1][1], m[2][1]),
            std::hypot(m[0][2], m[1][2], m[2][2])};
}

void set(std::vector<double>& values, std::size_t at, const std::array<double, 3>& channels, double factor) {
    for (std::size_t c = 0; c < 3; ++c)
        values[at + c] = factor * channels[c];
}

} // namespace

std::span<const std::vector<double>> general_ensemble() {
    constexpr int kHalfWaves = 64;
    constexpr double kAmplitude = 0.2, kBend = 2.5;
    static const std::vector<std::vector<double>> ensemble = [] {
        std::vector<std::vector<double>> out;
        for (int k = 1; k <= kHalfWaves; ++k) {
            const double amplitude = kAmplitude / (1 + k * k / (kBend * kBend));
            out.emplace_back(kReferenceGrid.count);
            for (std::size_t i = 0; i < kReferenceGrid.count; ++i)
                out.back()[i] = amplitude * std::cos(std::numbers::pi * k * static_cast<double>(i) /
                                                     static_cast<double>(kReferenceGrid.count - 1));
        }
        return out;
    }();
    return ensemble;
}

TapProblem tap_problem(std::span<const ReferenceLamp* const> lamps,
                       std::span<const std::vector<double>> own) {
    const auto general = general_ensemble();
    TapProblem p{own.size() + general.size(), 3 * lamps.size(), {}, {}, {}, {}};
    p.spectrum.insert(p.spectrum.end(), own.begin(), own.end());
    p.spectrum.insert(p.spectrum.end(), general.begin(), general.end());
    p.target.resize(p.rows * p.columns);
    p.visible.resize(p.rows * p.columns);
    p.white.resize(p.columns);
    const double own_share = own.empty() ? 0 : 1 / std::sqrt(static_cast<double>(own.size()));
    const double general_share = own.empty() ? 1 : kGeneralShare;
    const std::vector<double> perfect(kReferenceGrid.count, 1.0);
    for (std::size_t l = 0; l < lamps.size(); ++l) {
        const Xyz white = reference_xyz(*lamps[l], perfect);
        set(p.white, 3 * l, {white.x, white.y, white.z}, 1);
        const std::array<double, 3> gray = visibility(kGray * white);
        for (std::size_t row = 0; row < p.rows; ++row) {
            const Xyz xyz = reference_xyz(*lamps[l], p.spectrum[row]);
            const std::size_t at = row * p.columns + 3 * l;
            set(p.target, at, {xyz.x, xyz.y, xyz.z}, 1);
            const bool is_own = row < own.size();
            set(p.visible, at, is_own ? visibility(xyz) : gray, is_own ? own_share : general_share);
        }
    }
    return p;
}

} // namespace metamer
