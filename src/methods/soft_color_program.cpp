// The linear program with soft bounds.
#include <algorithm>
#include <cmath>

#include "color/matrix3.h"
#include "methods/color_program.h"

namespace metamer {

namespace {

constexpr double kMet = 1e-12; ///< what the color may miss, in XYZ
constexpr int kMostSteps = 200;

// log(1 + exp(x)), without overflow.
double softplus(double x) {
    return std::max(0.0, x) + std::log1p(std::exp(-std::abs(x)));
}

struct SoftDual {
    const ColorProgram& program;
    std::span<const double> weight, scale;
    double temperature;

    double bound_share(std::size_t i, const Triple& price) const {
        return (weight[i] - dot(price, program.color[i])) / (temperature * scale[i]);
    }

    double value(const Triple& price) const {
        double sum = dot(price, program.target);
        for (std::size_t i = 0; i < weight.size(); ++i)
            if (scale[i] > 0)
                sum += temperature * scale[i] * softplus(bound_share(i, price));
        return sum;
    }

    std::vector<double> reflectance(const Triple& price) const {
        std::vector<double> r(weight.size(), 0.5);
        for (std::size_t i = 0; i < r.size(); ++i)
            if (scale[i] > 0)
                r[i] = 1 / (1 + std::exp(-bound_share(i, price)));
        return r;
    }
};

/// The dual's slope: what the color misses. And its curvature.
struct Slopes {
    Triple gradient;
    Matrix3 hessian;
};

Slopes slopes(const SoftDual& dual, const Triple& price) {
    Slopes out{dual.program.target, {}};
    const std::vector<double> r = dual.reflectance(price);
    for (std::size_t i = 0; i < r.size(); ++i) {
        const Triple& color = dual.program.color[i];
        const double bend = dual.scale[i] > 0 ? r[i] * (1 - r[i]) / (dual.temperature * dual.scale[i]) : 0;
        for (std::size_t k = 0; k < 3; ++k) {
            out.gradient[k] -= color[k] * r[i];
            for (std::size_t l = 0; l < 3; ++l)
                out.hessian.m[k][l] += bend * color[k] * color[l];
        }
    }
    return out;
}

double length(const Triple& a) {
    return std::sqrt(dot(a, a));
}

// h x = b for a symmetric, positive h, by Cholesky's method; directions that h knows nothing of (a lamp of
// one or two lines) are left alone.
Triple solved(const Matrix3& h, const Triple& b) {
    Matrix3 l;
    Triple y{}, x{};
    const double least = 1e-14 * (h.m[0][0] + h.m[1][1] + h.m[2][2]);
    for (std::size_t i = 0; i < 3; ++i) {
        double rest = b[i], square = h.m[i][i];
        for (std::size_t j = 0; j < i; ++j) {
            double sum = h.m[i][j];
            for (std::size_t k = 0; k < j; ++k)
                sum -= l.m[i][k] * l.m[j][k];
            l.m[i][j] = l.m[j][j] > 0 ? sum / l.m[j][j] : 0;
            rest -= l.m[i][j] * y[j];
            square -= l.m[i][j] * l.m[i][j];
        }
        l.m[i][i] = square > least ? std::sqrt(square) : 0;
        y[i] = l.m[i][i] > 0 ? rest / l.m[i][i] : 0;
    }
    for (std::size_t i = 3; i-- > 0;) {
        double rest = y[i];
        for (std::size_t j = i + 1; j < 3; ++j)
            rest -= l.m[j][i] * x[j];
        x[i] = l.m[i][i] > 0 ? rest / l.m[i][i] : 0;
    }
    return x;
}

Triple moved(const Triple& from, double way, const Triple& direction) {
    return {from[0] - way * direction[0], from[1] - way * direction[1], from[2] - way * direction[2]};
}

// Newton's method from `price`; halves a step until it goes down (Armijo's rule). True when the color is met.
bool newton(const SoftDual& dual, Triple& price) {
    for (int step = 0; step < kMostSteps; ++step) {
        const Slopes at = slopes(dual, price);
        if (length(at.gradient) <= kMet)
            return true;
        const Triple direction = solved(at.hessian, at.gradient);
        const double fall = dot(direction, at.gradient), value = dual.value(price);
        double way = 1;
        // Near the end values differ by rounding only: there a whole step is right.
        const double blur = 1e-13 * std::max(1e-3, std::abs(value));
        while (way > 1e-12 && !(dual.value(moved(price, way, direction)) <= value - 1e-4 * way * fall + blur))
            way /= 2;
        price = moved(price, way, direction);
    }
    return false;
}

} // namespace

std::optional<Extreme> softly_greatest(const ColorProgram& program, std::span<const double> weight,
                                       std::span<const double> scale, double softness) {
    SoftDual dual{program, weight, scale, std::max(1.0, softness)};
    Triple price{};
    for (;;) {
        if (!newton(dual, price))
            return std::nullopt;
        if (dual.temperature <= softness)
            return Extreme{dual.reflectance(price), price};
        dual.temperature = std::max(softness, dual.temperature / 4);
    }
}

} // namespace metamer
