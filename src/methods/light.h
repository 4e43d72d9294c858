// The light that arrives at a pixel: twin of shaders_es/light.glsl. I_shading of equation 7.10, apart for
// what the material colors (diffuse) and what it mirrors unfiltered (specular).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "methods/scalar.h"

namespace metamer {

/// Shares of a lamp's light: `diffuse` is multiplied with the reflectance, `mirrored` is not, `bounced` with
/// the reflectance of the wall that it comes from first.
template <Scalar T>
struct Light {
    T diffuse = T(1);
    T mirrored = T(0);
    T bounced = T(0);
};

/// A lamp's place: position (`directional` false) or unit direction towards the lamp; falloff coefficients.
template <Scalar T>
struct LampPlace {
    std::array<T, 3> at{};
    bool directional = false;
    std::array<T, 3> falloff{T(1), T(0), T(0)};
};

/// A point of a surface, its unit normal, the eye, and how it mirrors.
template <Scalar T>
struct SurfacePoint {
    std::array<T, 3> position{}, normal{}, eye{};
    T specular{};
    T shininess = T(32);
};

/// The least value that the falloff's denominator takes: light near a lamp stays finite, in half too.
inline constexpr double kLeastFalloff = 1.0 / 64;
/// Vectors shorter than its root are not stretched to unit length: no division by zero, in half either.
inline constexpr double kLeastLengthSquared = 1e-4;

/// Lambert's cosine law, Blinn-Phong highlights (Blinn 1977), falloff 1 / (c + l d + q d^2); `visible` 0 .. 1
/// is what the shadow leaves.
template <Scalar T>
Light<T> arriving_light(const LampPlace<T>& lamp, const SurfacePoint<T>& p, T visible = T(1)) {
    using V = std::array<T, 3>;
    const auto dot = [](const V& a, const V& b) {
        return static_cast<T>(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
    };
    const auto minus = [](const V& a, const V& b) {
        return V{static_cast<T>(a[0] - b[0]), static_cast<T>(a[1] - b[1]), static_cast<T>(a[2] - b[2])};
    };
    const auto root = [](T v) { return static_cast<T>(std::sqrt(static_cast<double>(v))); };
    const auto unit = [&](const V& a) {
        const T length = root(std::max(dot(a, a), static_cast<T>(kLeastLengthSquared)));
        return V{static_cast<T>(a[0] / length), static_cast<T>(a[1] / length), static_cast<T>(a[2] / length)};
    };
    const V ray = lamp.directional ? lamp.at : minus(lamp.at, p.position);
    const T distance = lamp.directional ? T(0) : root(dot(ray, ray));
    const V towards_lamp = lamp.directional ? lamp.at : unit(ray);
    const V towards_eye = unit(minus(p.eye, p.position));
    const V half_way = unit({static_cast<T>(towards_lamp[0] + towards_eye[0]),
                             static_cast<T>(towards_lamp[1] + towards_eye[1]),
                             static_cast<T>(towards_lamp[2] + towards_eye[2])});
    const T fading =
        std::max(static_cast<T>(lamp.falloff[0] + distance * (lamp.falloff[1] + distance * lamp.falloff[2])),
                 static_cast<T>(kLeastFalloff));
    const T reach = static_cast<T>(visible / fading);
    const T cosine = std::max(dot(p.normal, towards_lamp), T(0));
    const T highlight = static_cast<T>(std::pow(static_cast<double>(std::max(dot(p.normal, half_way), T(0))),
                                                static_cast<double>(p.shininess)));
    const T mirrored = cosine > T(0) ? static_cast<T>(p.specular * highlight) : T(0);
    return {static_cast<T>(cosine * reach), static_cast<T>(mirrored * reach), T(0)};
}

/// The share of a plane's light that reaches a point of another plane at right angles to it, both without end
/// along their common edge: the form factor of a strip of height 1 seen from `distance` heights off the edge
/// (Hottel's crossed strings 1954), 1/2 at the edge.
template <Scalar T>
T bounce_share(T distance) {
    return static_cast<T>(T(0.5) - T(0.5) * distance /
                                       static_cast<T>(std::sqrt(
                                           static_cast<double>(static_cast<T>(distance * distance + T(1))))));
}

} // namespace metamer
