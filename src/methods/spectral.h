// Method `spectral`, the thesis's loop: lamp x reflectance x observer, wavelength by wavelength, over the
// atlas. Twin of shaders_es/spectral.frag, operation by operation.
#pragma once

#include <span>

#include "color/observer.h"
#include "color/spectrum.h"
#include "color/xyz.h"
#include "methods/light.h"

namespace metamer {

/// A lamp's row, its strength (I_source) and its light at the pixel (I_shading).
template <Scalar T>
struct LitEmission {
    const Emission* emission;
    T strength = T(1);
    Light<T> light;
};

/// XYZ at a pixel, summed over the lamps: equations 7.1 and 7.6-7.10, phi_i = (R_i diffuse + mirrored) S_i. A
/// lamp with k' = 0 must not come here: atlas/atlas_check.h refuses such rows.
template <Scalar T>
BasicXyz<T> spectral(std::span<const LitEmission<T>> lamps, const Reflectance& reflectance,
                     const GridObserver& observer) {
    BasicXyz<T> total;
    for (const LitEmission<T>& lamp : lamps) {
        BasicXyz<T> sum;
        T k{};
        for (std::size_t i = 0; i < kIntervals; ++i) {
            const T s = static_cast<T>(lamp.emission->value[i]), r = static_cast<T>(reflectance.value[i]);
            const T x = static_cast<T>(observer.x[i]), y = static_cast<T>(observer.y[i]),
                    z = static_cast<T>(observer.z[i]);
            const T phi = static_cast<T>((r * lamp.light.diffuse + lamp.light.mirrored) * s);
            sum.x = static_cast<T>(sum.x + x * phi);
            sum.y = static_cast<T>(sum.y + y * phi);
            sum.z = static_cast<T>(sum.z + z * phi);
            k = static_cast<T>(k + y * s);
        }
        const T scale = static_cast<T>(lamp.strength / k);
        total.x = static_cast<T>(total.x + scale * sum.x);
        total.y = static_cast<T>(total.y + scale * sum.y);
        total.z = static_cast<T>(total.z + scale * sum.z);
    }
    return total;
}

} // namespace metamer
