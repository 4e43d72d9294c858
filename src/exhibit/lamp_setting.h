// [lamp.N]: a lamp as an exhibit sets it.
#pragma once

#include <array>
#include <optional>

#include "spectra/library.h"

namespace metamer {

using Vec3 = std::array<double, 3>;

/// I(d) = 1 / (constant + linear d + quadratic d^2), d in scene units from the lamp. Only point lamps have
/// one.
struct Falloff {
    double constant = 1, linear = 0, quadratic = 0;
};

/// [lamp.N]
struct LampSetting {
    Lamp lamp;                   ///< its spectrum; one of the atlas file is known by its row only
    bool full_resolution = true; ///< false: found in the atlas file
    int key = 0;                 ///< its row in Exhibit::atlas
    double strength = 1;         ///< I_source
    /// A point lamp at x, y, z in scene units (x to the right, y up, z to the visitor), or parallel light
    /// that travels along x, y, z (length 1); neither: where the scene has its lamp of that number.
    std::optional<Vec3> position;
    std::optional<Vec3> direction;
    Falloff falloff;
    bool shadow = false;
};

} // namespace metamer
