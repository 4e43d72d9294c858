// Methods `rgb`, `tristimulus` and `prefiltered`: three numbers of the lamp times three numbers of the
// material. The same arithmetic in three spaces; twin of shaders_es/product.glsl.
#pragma once

#include <array>
#include <cmath>
#include <span>
#include <type_traits>

#include "methods/light.h"

namespace metamer {

/// A lamp's color in the method's space, its strength already in it, and its light at the pixel.
template <Scalar T>
struct LitColor {
    std::array<T, 3> color{};
    Light<T> light;
};

/// Three numbers of each thing that filters the light.
template <Scalar T>
struct ProductLayers {
    std::array<T, 3> material{};
    std::array<T, 3> medium_log2{}; ///< of the transmittance at thickness 1
    T thickness{};                  ///< 0: no medium
    std::array<T, 3> other{};       ///< of the wall that Light::bounced comes from
};

/// 2^v as a GPU's special function unit has it: in float for half.
template <Scalar T>
T exponential(T v) {
    return static_cast<T>(std::exp2(static_cast<std::conditional_t<sizeof(T) == 8, double, float>>(v)));
}

/// Per component: the sum over the lamps of color (material (diffuse + bounced other) medium^thickness +
/// mirrored).
template <Scalar T>
std::array<T, 3> product(std::span<const LitColor<T>> lamps, const ProductLayers<T>& layers) {
    std::array<T, 3> total{};
    for (std::size_t c = 0; c < 3; ++c) {
        T material = layers.material[c];
        if (layers.thickness > T(0))
            material = static_cast<T>(material *
                                      exponential(static_cast<T>(layers.medium_log2[c] * layers.thickness)));
        for (const LitColor<T>& lamp : lamps) {
            const T arriving = static_cast<T>(lamp.light.diffuse + lamp.light.bounced * layers.other[c]);
            const T returned = static_cast<T>(lamp.color[c] * (material * arriving + lamp.light.mirrored));
            total[c] = static_cast<T>(total[c] + bounded(returned));
        }
    }
    return total;
}

} // namespace metamer
