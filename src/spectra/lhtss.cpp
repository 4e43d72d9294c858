#include "spectra/lhtss.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "color/colorimetry.h"
#include "color/resample.h"
#include "spectra/linear_solve.h"
#include "spectra/tables.h"

namespace metamer {

namespace {

constexpr Grid kKnots{380, 5, 81};
constexpr std::size_t kUnknowns = kKnots.count + 3; // z, then Lagrange's multipliers

using Triple = std::array<double, 3>;

// XYZ under D65 per unit of reflectance at each knot.
using KnotColors = std::array<Triple, kKnots.count>;

MaterialSpectrum on_knots(const std::vector<double>& rho) {
    Curve curve{{}, rho};
    for (std::size_t i = 0; i < kKnots.count; ++i)
        curve.wavelength_nm.push_back(kKnots.wavelength_nm(i));
    return {curve};
}

// The reference integration is linear in the reflectance: its columns, one knot at a time.
const KnotColors& knot_colors() {
    static const KnotColors colors = [] {
        const ReferenceLamp d65 = reference_lamp({column(cie_illuminants(), "D65"), {}});
        KnotColors out{};
        for (std::size_t i = 0; i < kKnots.count; ++i) {
            std::vector<double> one(kKnots.count, 0.0);
            one[i] = 1;
            const Xyz c = reference_xyz(d65, resample(on_knots(one), kReferenceGrid));
            out[i] = {c.x, c.y, c.z};
        }
        return out;
    }();
    return colors;
}

// (tanh z + 1) / 2 without the cancellation of tanh near -1.
double rho_of(double z) {
    return 1 / (1 + std::exp(-2 * z));
}

struct System {
    SquareMatrix jacobian{kUnknowns};
    std::vector<double> residual = std::vector<double>(kUnknowns, 0.0);
};

// Lagrange's conditions at u = (z, multipliers) and their derivatives.
System system_at(const std::vector<double>& u, const Triple& target) {
    constexpr std::size_t n = kKnots.count;
    System s;
    // Half the gradient of the sum of squared steps.
    for (std::size_t i = 0; i + 1 < n; ++i) {
        const double step = u[i + 1] - u[i];
        s.residual[i] -= step;
        s.residual[i + 1] += step;
        s.jacobian(i, i) += 1;
        s.jacobian(i + 1, i + 1) += 1;
        s.jacobian(i, i + 1) -= 1;
        s.jacobian(i + 1, i) -= 1;
    }
    for (std::size_t k = 0; k < 3; ++k)
        s.residual[n + k] = -target[k];
    for (std::size_t i = 0; i < n; ++i) {
        const double rho = rho_of(u[i]);
        const double slope = 2 * rho * rho_of(-u[i]); // d rho / d z
        const double bend = 2 * slope * (1 - 2 * rho);
        for (std::size_t k = 0; k < 3; ++k) {
            const double t = knot_colors()[i][k];
            s.residual[i] += u[n + k] * t * slope;
            s.residual[n + k] += t * rho;
            s.jacobian(i, i) += u[n + k] * t * bend;
            s.jacobian(i, n + k) = s.jacobian(n + k, i) = t * slope;
        }
    }
    return s;
}

double greatest(const std::vector<double>& v, std::size_t first, std::size_t last) {
    double most = 0;
    for (std::size_t i = first; i < last; ++i)
        most = std::max(most, std::isfinite(v[i]) ? std::abs(v[i]) : HUGE_VAL);
    return most;
}

// Newton's method from `u`; a step moves no z by more than 2, so that tanh never leaves the range where it
// has a slope at one stroke. True, and u at the solution, when color and smoothness conditions hold.
bool newton(std::vector<double>& u, const Triple& target) {
    constexpr int kMostSteps = 40;
    for (int step = 0; step < kMostSteps; ++step) {
        System s = system_at(u, target);
        if (greatest(s.residual, kKnots.count, kUnknowns) < 1e-11 &&
            greatest(s.residual, 0, kKnots.count) < 1e-7)
            return true;
        const auto direction = solve(std::move(s.jacobian), std::move(s.residual));
        if (!direction)
            return false;
        const double damping = std::min(1.0, 2 / std::max(1e-300, greatest(*direction, 0, kKnots.count)));
        for (std::size_t i = 0; i < kUnknowns; ++i)
            u[i] -= damping * (*direction)[i];
    }
    return false;
}

Triple white() {
    Triple sum{};
    for (const Triple& t : knot_colors())
        for (std::size_t k = 0; k < 3; ++k)
            sum[k] += t[k];
    return sum;
}

} // namespace

std::optional<MaterialSpectrum> lhtss(const Xyz& target) {
    const double gray = std::clamp(target.y, 0.001, 0.98);
    const Triple end{target.x, target.y, target.z};
    const Triple w = white();
    // The gray solves its own problem with all multipliers 0.
    std::vector<double> u(kUnknowns, 0.0);
    std::fill_n(u.begin(), kKnots.count, std::atanh(2 * gray - 1));
    double done = 0, step = 1;
    while (done < 1) {
        const double next = std::min(1.0, done + step);
        Triple way{};
        for (std::size_t k = 0; k < 3; ++k)
            way[k] = (1 - next) * gray * w[k] + next * end[k];
        std::vector<double> trial = u;
        if (newton(trial, way)) {
            u = std::move(trial);
            done = next;
            step *= 2;
        } else if ((step /= 2) < 1.0 / 256) {
            return std::nullopt;
        }
    }
    std::vector<double> rho(kKnots.count);
    std::transform(u.begin(), u.begin() + kKnots.count, rho.begin(), rho_of);
    if (!std::all_of(rho.begin(), rho.end(), [](double r) { return r > 0 && r < 1; }))
        return std::nullopt;
    return on_knots(rho);
}

} // namespace metamer
