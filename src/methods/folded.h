// Method `folded`: one bounce of light is linear in lamp and material, so a pair's color is a constant,
// summed before the frame in double. Twin of shaders_es/folded.frag.
#pragma once

#include <array>
#include <span>

#include "methods/light.h"

namespace metamer {

/// What is left of a lamp and a material: linear RGB of the display, strength in it.
template <Scalar T>
struct FoldedLamp {
    std::array<T, 3> reflected{}; ///< by the material
    std::array<T, 3> mirrored{};  ///< the lamp itself
    std::array<T, 3> bounced{};   ///< by the other wall, then by the material
    Light<T> light;
};

/// Linear RGB at the pixel.
template <Scalar T>
std::array<T, 3> folded(std::span<const FoldedLamp<T>> lamps) {
    std::array<T, 3> total{};
    for (const FoldedLamp<T>& lamp : lamps)
        for (std::size_t c = 0; c < 3; ++c)
            total[c] =
                static_cast<T>(total[c] + bounded(static_cast<T>(lamp.reflected[c] * lamp.light.diffuse)) +
                               bounded(static_cast<T>(lamp.mirrored[c] * lamp.light.mirrored)) +
                               bounded(static_cast<T>(lamp.bounced[c] * lamp.light.bounced)));
    return total;
}

} // namespace metamer
