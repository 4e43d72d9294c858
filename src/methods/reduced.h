// Method `reduced`: a few wavelengths chosen and weighted for the scene's own lamps (taps.h), for what is not
// linear in a pixel: a medium of varying thickness, light from a second wall. Twin of
// shaders_es/reduced.frag.
#pragma once

#include <array>
#include <span>

#include "methods/product.h"

namespace metamer {

/// One wavelength under one lamp.
template <Scalar T>
struct TapWeight {
    std::array<T, 3>
        rgb{}; ///< linear RGB of the display; strength, matrix and the material's reflectance in it
};

/// What all lamps share at that wavelength.
template <Scalar T>
struct TapLayers {
    T medium_log2{}; ///< of the transmittance at thickness 1
    T other{};       ///< reflectance of the other wall
};

template <Scalar T>
struct ReducedLamp {
    std::span<const TapWeight<T>> taps;
    std::array<T, 3> mirrored{}; ///< the lamp itself
    Light<T> light;
};

/// Linear RGB at the pixel: per lamp the sum over the taps of weight (diffuse + bounced other)
/// medium^thickness.
template <Scalar T>
std::array<T, 3> reduced(std::span<const ReducedLamp<T>> lamps, std::span<const TapLayers<T>> layers,
                         T thickness) {
    std::array<T, 3> total{};
    for (std::size_t i = 0; i < layers.size(); ++i) {
        const T passed =
            thickness > T(0) ? exponential(static_cast<T>(layers[i].medium_log2 * thickness)) : T(1);
        for (const ReducedLamp<T>& lamp : lamps) {
            const T share =
                static_cast<T>((lamp.light.diffuse + lamp.light.bounced * layers[i].other) * passed);
            for (std::size_t c = 0; c < 3; ++c)
                total[c] = static_cast<T>(total[c] + bounded(static_cast<T>(lamp.taps[i].rgb[c] * share)));
        }
    }
    for (const ReducedLamp<T>& lamp : lamps)
        for (std::size_t c = 0; c < 3; ++c)
            total[c] =
                static_cast<T>(total[c] + bounded(static_cast<T>(lamp.mirrored[c] * lamp.light.mirrored)));
    return total;
}

} // namespace metamer
