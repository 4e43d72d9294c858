// What the eye gets of a lamp, wavelength by wavelength.
#pragma once

#include <vector>

#include "color/colorimetry.h"
#include "color/observer.h"
#include "methods/color_program.h"

namespace metamer {

/// XYZ of each nanometre of kReferenceGrid, Y = 1 for all of them together.
inline std::vector<Triple> lamp_colors(const ReferenceLamp& lamp) {
    std::vector<Triple> out;
    for (std::size_t i = 0; i < kReferenceGrid.count; ++i) {
        const ColorMatching& c = cie_1931_2deg()[i];
        const double light = lamp.power[i] / lamp.k;
        out.push_back({light * c.x, light * c.y, light * c.z});
    }
    return out;
}

} // namespace metamer
