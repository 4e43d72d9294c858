// The transfer curve: light to code values. The one place for its constants; shaders get them from here.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

#include "color/xyz.h"

namespace metamer {

/// `srgb`: IEC 61966-2-1; `none`: code values are light.
enum class Transfer { srgb, none };

/// The sRGB curve, IEC 61966-2-1:1999 section 5.2, encoding: 12.92 v up to 0.0031308, above it
/// 1.055 v^(1/2.4) - 0.055.
struct SrgbCurve {
    static constexpr double kLinearUpTo = 0.0031308;
    static constexpr double kSlope = 12.92;
    static constexpr double kScale = 1.055;
    static constexpr double kOffset = 0.055;
    static constexpr double kGamma = 2.4;
};

/// The same curve for shaders, without pow(): a polynomial in the root of v, found by minimax fit over
/// kLinearUpTo .. 1, under it the line of the standard. At most 0.24 of a step of 8 bits off the standard, in
/// half precision 0.46.
struct SrgbPolynomial {
    /// Of 1, s, s^2, s^3, s^4 with s = sqrt(v).
    static constexpr std::array<double, 5> kOfRoot{-0.03700467, 1.44789938, -0.94486106, 0.8427913,
                                                   -0.30957192};
    /// What the line ends at: SrgbCurve::kSlope * kLinearUpTo. The polynomial runs below it up to there.
    static constexpr double kLineUpTo = SrgbCurve::kSlope * SrgbCurve::kLinearUpTo;
};

/// Light 0 .. 1 to code value 0 .. 1; clamps first. T: double, float or half.
template <class T>
T encode(Transfer transfer, T v) {
    v = std::min(std::max(v, T(0)), T(1));
    if (transfer == Transfer::none)
        return v;
    if (v <= static_cast<T>(SrgbCurve::kLinearUpTo))
        return static_cast<T>(static_cast<T>(SrgbCurve::kSlope) * v);
    // Powers are taken in float for half, as a GPU's special function unit does, then rounded.
    const auto wide =
        std::pow(static_cast<std::conditional_t<sizeof(T) == 8, double, float>>(v),
                 static_cast<std::conditional_t<sizeof(T) == 8, double, float>>(1 / SrgbCurve::kGamma));
    return static_cast<T>(static_cast<T>(SrgbCurve::kScale) * static_cast<T>(wide) -
                          static_cast<T>(SrgbCurve::kOffset));
}

/// Light 0 .. 1 to code value 0 .. 1 as shaders_es/output.glsl computes it; clamps first.
template <class T>
T encode_by_polynomial(T v) {
    v = std::min(std::max(v, T(0)), T(1));
    const auto& c = SrgbPolynomial::kOfRoot;
    const T root =
        static_cast<T>(std::sqrt(static_cast<std::conditional_t<sizeof(T) == 8, double, float>>(v)));
    T curved = static_cast<T>(c.back());
    for (std::size_t i = c.size() - 1; i-- > 0;)
        curved = static_cast<T>(curved * root + static_cast<T>(c[i]));
    const T line = std::min(static_cast<T>(static_cast<T>(SrgbCurve::kSlope) * v),
                            static_cast<T>(SrgbPolynomial::kLineUpTo));
    return std::max(curved, line);
}

/// Code value 0 .. 1 to light 0 .. 1.
double decode(Transfer transfer, double code);

/// Clamp, curve, round half up to 8 bits: what the framebuffer does (OpenGL ES 2.0.25 section 2.1.2).
template <class T>
EncodedRgb8 encode_rgb8(Transfer transfer, const BasicLinearRgb<T>& c) {
    const auto code = [&](T v) {
        return static_cast<std::uint8_t>(std::floor(static_cast<double>(encode(transfer, v)) * 255 + 0.5));
    };
    return {code(c.r), code(c.g), code(c.b)};
}

LinearRgb decode_rgb8(Transfer transfer, const EncodedRgb8& c);

} // namespace metamer
