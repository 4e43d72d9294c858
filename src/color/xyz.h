// Colors as three numbers; the type says which three.
#pragma once

#include <cstdint>

namespace metamer {

/// CIE 1931 tristimulus values; Y = 1 for the perfect reflector under the lamp at hand.
template <class T>
struct BasicXyz {
    T x{}, y{}, z{};
};

/// Light in a working space, linear, unclamped: 0 black, 1 the space's white.
template <class T>
struct BasicLinearRgb {
    T r{}, g{}, b{};
};

using Xyz = BasicXyz<double>;
using LinearRgb = BasicLinearRgb<double>;

/// What a framebuffer holds: after clamping, the transfer curve and rounding to 8 bits.
struct EncodedRgb8 {
    std::uint8_t r{}, g{}, b{};
    bool operator==(const EncodedRgb8&) const = default;
};

/// CIE 1931 chromaticity coordinates.
struct Chromaticity {
    double x{}, y{};
};

constexpr Xyz operator+(const Xyz& a, const Xyz& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
constexpr Xyz operator*(double s, const Xyz& a) {
    return {s * a.x, s * a.y, s * a.z};
}

} // namespace metamer
