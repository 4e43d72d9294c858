// Method `packed`: the 64 wavelengths of `spectral`, four to an RGBA texel; each round adds a sum of four,
// which half precision bears better than 64 terms in one sum. Twin of shaders_es/packed.frag.
#pragma once

#include "methods/spectral.h"
#include "methods/three_numbers.h"

namespace metamer {

inline constexpr std::size_t kPackedRounds = kIntervals / 4;

/// As spectral(); k' is summed in double before, on the CPU.
template <Scalar T>
BasicXyz<T> packed(std::span<const LitEmission<T>> lamps, const SpectralLayers<T>& layers,
                   const GridObserver& observer) {
    BasicXyz<T> total;
    for (const LitEmission<T>& lamp : lamps) {
        BasicXyz<T> sum;
        for (std::size_t round = 0; round < kPackedRounds; ++round) {
            std::array<T, 4> phi;
            for (std::size_t i = 0; i < 4; ++i)
                phi[i] = static_cast<T>(filtered(layers, lamp.light, 4 * round + i) *
                                        static_cast<T>(lamp.emission->value[4 * round + i]));
            const auto dot = [&](const std::array<double, kIntervals>& weight) {
                T four{};
                for (std::size_t i = 0; i < 4; ++i)
                    four = static_cast<T>(four + static_cast<T>(weight[4 * round + i]) * phi[i]);
                return four;
            };
            sum.x = static_cast<T>(sum.x + dot(observer.x));
            sum.y = static_cast<T>(sum.y + dot(observer.y));
            sum.z = static_cast<T>(sum.z + dot(observer.z));
        }
        const T scale =
            uploaded<T>(packed_scale(*lamp.emission, static_cast<double>(lamp.strength), observer));
        const auto scaled = [&](T v) { return bounded(static_cast<T>(bounded(v) * scale)); };
        total.x = static_cast<T>(total.x + scaled(sum.x));
        total.y = static_cast<T>(total.y + scaled(sum.y));
        total.z = static_cast<T>(total.z + scaled(sum.z));
    }
    return total;
}

} // namespace metamer
