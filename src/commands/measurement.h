// A lamp and a material by every method, on the CPU and on the GPU, against the reference.
#pragma once

#include <string>
#include <vector>

#include "color/xyz.h"
#include "exhibit/exhibit.h"

namespace metamer {

/// What one method makes of the pair.
struct MethodMeasurement {
    Method method;
    Xyz xyz;              ///< double precision on the atlas's rows
    double delta_e_2000;  ///< xyz against the reference
    EncodedRgb8 cpu_rgb8; ///< the CPU twin in float
    EncodedRgb8 gpu_rgb8; ///< read back from a frame
};

struct Measurement {
    std::string lamp, material;
    Xyz reference; ///< full-resolution spectra, 1 nm, double
    std::vector<MethodMeasurement> methods;
};

/// Measures at strength 1, I_shading = 1, in the display's working space, matrix, transfer curve and
/// adaptation. Needs a current ES 2 context.
Measurement measure(const Lamp& lamp, const Material& material, const Display& display);

/// The exhibit of one patch that `measure` draws: this lamp on this material by this method.
Exhibit pair_exhibit(const Lamp& lamp, const Material& material, const Display& display, Method method);

} // namespace metamer
