// 3 x 3 matrices; they read right to left: rgb_from_xyz * xyz.
#pragma once

#include <array>
#include <optional>

#include "color/xyz.h"

namespace metamer {

/// Row-major: m[row][column].
struct Matrix3 {
    std::array<std::array<double, 3>, 3> m{};

    static constexpr Matrix3 identity() { return {{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}}; }
    static constexpr Matrix3 diagonal(double a, double b, double c) {
        return {{{{a, 0, 0}, {0, b, 0}, {0, 0, c}}}};
    }
};

Matrix3 operator*(const Matrix3& a, const Matrix3& b);
std::array<double, 3> operator*(const Matrix3& a, const std::array<double, 3>& v);

/// The inverse; none when a is singular to working accuracy: |det a| <= 1e-9 * (product of the row lengths),
/// which asks that the rows span a volume of more than a billionth of the box of their lengths.
std::optional<Matrix3> inverse(const Matrix3& a);

/// Light into the working space that `rgb_from_xyz` stands for. T: double, float or half (the CPU twins).
template <class T>
BasicLinearRgb<T> to_linear_rgb(const Matrix3& rgb_from_xyz, const BasicXyz<T>& c) {
    const auto row = [&](std::size_t i) {
        const auto& m = rgb_from_xyz.m[i];
        return static_cast<T>(static_cast<T>(m[0]) * c.x + static_cast<T>(m[1]) * c.y +
                              static_cast<T>(m[2]) * c.z);
    };
    return {row(0), row(1), row(2)};
}

/// And back, in double.
Xyz to_xyz(const Matrix3& xyz_from_rgb, const LinearRgb& c);

} // namespace metamer
