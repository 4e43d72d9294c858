#include "color/matrix3.h"

#include <cmath>

namespace metamer {

Matrix3 operator*(const Matrix3& a, const Matrix3& b) {
    Matrix3 c;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            for (std::size_t k = 0; k < 3; ++k)
                c.m[i][j] += a.m[i][k] * b.m[k][j];
    return c;
}

std::array<double, 3> operator*(const Matrix3& a, const std::array<double, 3>& v) {
    std::array<double, 3> out{};
    for (std::size_t i = 0; i < 3; ++i)
        out[i] = a.m[i][0] * v[0] + a.m[i][1] * v[1] + a.m[i][2] * v[2];
    return out;
}

std::optional<Matrix3> inverse(const Matrix3& a) {
    const auto& m = a.m;
    // Cofactors by cyclic indices carry their signs themselves.
    const auto cofactor = [&](std::size_t i, std::size_t j) {
        const std::size_t i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
        return m[i1][j1] * m[i2][j2] - m[i1][j2] * m[i2][j1];
    };
    const double det = m[0][0] * cofactor(0, 0) + m[0][1] * cofactor(0, 1) + m[0][2] * cofactor(0, 2);
    double box = 1;
    for (const auto& row : m)
        box *= std::hypot(row[0], row[1], row[2]);
    if (!(std::abs(det) > 1e-9 * box))
        return std::nullopt;
    Matrix3 out;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            out.m[i][j] = cofactor(j, i) / det;
    return out;
}

Xyz to_xyz(const Matrix3& xyz_from_rgb, const LinearRgb& c) {
    const auto v = xyz_from_rgb * std::array<double, 3>{c.r, c.g, c.b};
    return {v[0], v[1], v[2]};
}

} // namespace metamer
