#include "color/difference.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "color/colorimetry.h"

namespace metamer {

namespace {

constexpr double kDegree = std::numbers::pi / 180;

double f(double t) {
    constexpr double delta = 6.0 / 29;
    return t > delta * delta * delta ? std::cbrt(t) : t / (3 * delta * delta) + 4.0 / 29;
}

double f_slope(double t) {
    constexpr double delta = 6.0 / 29;
    if (t <= delta * delta * delta)
        return 1 / (3 * delta * delta);
    const double root = std::cbrt(t);
    return 1 / (3 * root * root);
}

double hue_deg(double a, double b) {
    if (a == 0 && b == 0)
        return 0;
    const double h = std::atan2(b, a) / kDegree;
    return h < 0 ? h + 360 : h;
}

double pow7_share(double c) {
    const double c7 = std::pow(c, 7);
    return std::sqrt(c7 / (c7 + std::pow(25.0, 7)));
}

double hue_difference_deg(double h1, double h2, bool gray) {
    if (gray)
        return 0;
    const double d = h2 - h1;
    return d > 180 ? d - 360 : d < -180 ? d + 360 : d;
}

double mean_hue_deg(double h1, double h2, bool gray) {
    if (gray)
        return h1 + h2;
    if (std::abs(h1 - h2) <= 180)
        return (h1 + h2) / 2;
    return h1 + h2 < 360 ? (h1 + h2 + 360) / 2 : (h1 + h2 - 360) / 2;
}

// S_L, S_C, S_H and R_T of a lightness, a chroma and a hue.
struct Terms {
    double sl, sc, sh, rt;
};

Terms terms(double l, double c, double h) {
    const double t = 1 - 0.17 * std::cos((h - 30) * kDegree) + 0.24 * std::cos(2 * h * kDegree) +
                     0.32 * std::cos((3 * h + 6) * kDegree) - 0.20 * std::cos((4 * h - 63) * kDegree);
    const double l50 = (l - 50) * (l - 50);
    const double turn_deg = 30 * std::exp(-std::pow((h - 275) / 25, 2));
    return {1 + 0.015 * l50 / std::sqrt(20 + l50), 1 + 0.045 * c, 1 + 0.015 * c * t,
            -2 * pow7_share(c) * std::sin(2 * turn_deg * kDegree)};
}

} // namespace

Xyz display_white() {
    return xyz_of({0.3127, 0.3290});
}

Lab lab(const Xyz& c, const Xyz& white) {
    const double fx = f(c.x / white.x), fy = f(c.y / white.y), fz = f(c.z / white.z);
    return {116 * fy - 16, 500 * (fx - fy), 200 * (fy - fz)};
}

double delta_e_2000(const Lab& p, const Lab& q) {
    const double g = 0.5 * (1 - pow7_share((std::hypot(p.a, p.b) + std::hypot(q.a, q.b)) / 2));
    const double a1 = (1 + g) * p.a, a2 = (1 + g) * q.a;
    const double c1 = std::hypot(a1, p.b), c2 = std::hypot(a2, q.b);
    const double h1 = hue_deg(a1, p.b), h2 = hue_deg(a2, q.b);
    const bool gray = c1 * c2 == 0;

    const double dl = q.l - p.l, dc = c2 - c1;
    const double dh = 2 * std::sqrt(c1 * c2) * std::sin(hue_difference_deg(h1, h2, gray) / 2 * kDegree);
    const double l = (p.l + q.l) / 2, c = (c1 + c2) / 2, h = mean_hue_deg(h1, h2, gray);
    const auto [sl, sc, sh, rt] = terms(l, c, h);

    const double x = dl / sl, y = dc / sc, z = dh / sh;
    // Rounding may leave the sum of equal colors just below 0; NaN stays NaN.
    const double square = x * x + y * y + z * z + rt * y * z;
    return square < 0 ? 0 : std::sqrt(square);
}

double delta_e_2000(const Xyz& a, const Xyz& b) {
    const Xyz white = display_white();
    return delta_e_2000(lab(a, white), lab(b, white));
}

// G, S_L .. R_T are taken at the mean of the two colors: in the limit they are constants.
Matrix3 delta_e_2000_slopes(const Xyz& color) {
    const Xyz white = display_white();
    const Lab p = lab(color, white);
    const double stretch = 1 + 0.5 * (1 - pow7_share(std::hypot(p.a, p.b)));
    const double a = stretch * p.a, c = std::hypot(a, p.b);
    const auto [sl, sc, sh, rt] = terms(p.l, c, hue_deg(a, p.b));
    const double x = f_slope(color.x / white.x) / white.x, y = f_slope(color.y / white.y) / white.y,
                 z = f_slope(color.z / white.z) / white.z;
    const Matrix3 lab_slopes{
        {{{0, 116 * y, 0}, {500 * stretch * x, -500 * stretch * y, 0}, {0, 200 * y, -200 * z}}}};
    const double cosine = c > 0 ? a / c : 1, sine = c > 0 ? p.b / c : 0;
    const Matrix3 chroma_and_hue{
        {{{1 / sl, 0, 0}, {0, cosine / sc, sine / sc}, {0, -sine / sh, cosine / sh}}}};
    // u^2 + v^2 + rt u v, completed to squares; |rt| < 2.
    const Matrix3 squares{{{{1, 0, 0}, {0, 1, rt / 2}, {0, 0, std::sqrt(1 - rt * rt / 4)}}}};
    return squares * chroma_and_hue * lab_slopes;
}

} // namespace metamer
