// Methods `rgb` and `tristimulus`: three numbers of the lamp times three numbers of the material. The same
// arithmetic in two spaces; twin of shaders_es/product.glsl.
#pragma once

#include <array>
#include <span>

#include "methods/light.h"

namespace metamer {

/// A lamp's color in the method's space, its strength already in it, and its light at the pixel.
template <Scalar T>
struct LitColor {
    std::array<T, 3> color{};
    Light<T> light;
};

/// Per component: the sum over the lamps of color (material diffuse + mirrored).
template <Scalar T>
std::array<T, 3> product(std::span<const LitColor<T>> lamps, const std::array<T, 3>& material) {
    std::array<T, 3> total{};
    for (const LitColor<T>& lamp : lamps)
        for (std::size_t c = 0; c < 3; ++c)
            total[c] = static_cast<T>(
                total[c] + lamp.color[c] * (material[c] * lamp.light.diffuse + lamp.light.mirrored));
    return total;
}

} // namespace metamer
