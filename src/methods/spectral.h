// Method `spectral`, the thesis's loop: lamp x reflectance x observer, wavelength by wavelength, over the
// atlas. Twin of shaders_es/spectral.frag, operation by operation.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "color/observer.h"
#include "color/spectrum.h"
#include "color/xyz.h"
#include "methods/pixel.h"
#include "methods/product.h"

namespace metamer {

/// A lamp's row, its strength (I_source) and its light at the pixel (I_shading).
template <Scalar T>
struct LitEmission {
    const Emission* emission;
    T strength = T(1);
    Light<T> light;
};

/// What the light passes, on the atlas's rows.
template <Scalar T>
struct SpectralLayers {
    const Reflectance* material;
    const Reflectance* medium = nullptr;
    T thickness{};
    const Reflectance* other = nullptr;
};

/// What a lamp's light is multiplied with at interval i: equation 7.1 with what stands before and beside it.
template <Scalar T>
T filtered(const SpectralLayers<T>& layers, const Light<T>& light, std::size_t i) {
    T reflected = static_cast<T>(layers.material->value[i]);
    if (layers.medium) {
        const T least = static_cast<T>(kLeastTransmittance);
        const T t = std::max(static_cast<T>(layers.medium->value[i]), least);
        const T log2 = static_cast<T>(std::log2(static_cast<double>(t)));
        reflected = static_cast<T>(reflected * exponential(static_cast<T>(log2 * layers.thickness)));
    }
    T arriving = light.diffuse;
    if (layers.other)
        arriving = static_cast<T>(arriving + light.bounced * static_cast<T>(layers.other->value[i]));
    return static_cast<T>(reflected * arriving + light.mirrored);
}

/// k' in the loop may be all but 0 where the 8-bit observer is: below this a lamp is dark instead of
/// dividing.
inline constexpr double kLeastK = 1.0 / 4096;

/// XYZ at a pixel, summed over the lamps: equations 7.1 and 7.6-7.10.
template <Scalar T>
BasicXyz<T> spectral(std::span<const LitEmission<T>> lamps, const SpectralLayers<T>& layers,
                     const GridObserver& observer) {
    BasicXyz<T> total;
    for (const LitEmission<T>& lamp : lamps) {
        BasicXyz<T> sum;
        T k{};
        for (std::size_t i = 0; i < kIntervals; ++i) {
            const T s = static_cast<T>(lamp.emission->value[i]);
            const T x = static_cast<T>(observer.x[i]), y = static_cast<T>(observer.y[i]),
                    z = static_cast<T>(observer.z[i]);
            const T phi = static_cast<T>(filtered(layers, lamp.light, i) * s);
            sum.x = static_cast<T>(sum.x + x * phi);
            sum.y = static_cast<T>(sum.y + y * phi);
            sum.z = static_cast<T>(sum.z + z * phi);
            k = static_cast<T>(k + y * s);
        }
        const T divisor = std::max(k, static_cast<T>(kLeastK));
        const auto scaled = [&](T v) {
            return bounded(static_cast<T>(bounded(static_cast<T>(v / divisor)) * lamp.strength));
        };
        total.x = static_cast<T>(total.x + scaled(sum.x));
        total.y = static_cast<T>(total.y + scaled(sum.y));
        total.z = static_cast<T>(total.z + scaled(sum.z));
    }
    return total;
}

} // namespace metamer
