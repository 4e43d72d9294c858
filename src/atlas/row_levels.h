// The 8-bit rows of Quantization::weighted.
#pragma once

#include <span>

#include "atlas/levels.h"
#include "atlas/material_fit.h"

namespace metamer {

/// A lamp's levels, the greatest 255, and what that one stands for in the lamp's unit of power per nm.
struct LampLevels {
    std::array<std::uint8_t, kIntervals> level;
    double peak;
};

/// The lamp must be seen (is_seen).
LampLevels lamp_levels(const LampPower& power);

/// A material's levels: reflectance = level / 255 * scale, 0 < scale <= 1. Of several scales from the
/// greatest reflectance up to 10 % above it, the one whose levels come out best: what is dark beside a bright
/// band falls on a level rather than between two.
struct MaterialLevels {
    std::array<std::uint8_t, kIntervals> level;
    double scale;
};
MaterialLevels material_levels(const MaterialSpectrum& material, std::span<const PriorLamp> own = {});

/// x, y, z of weighted_observer() in levels, the greatest weight 255. Each rounding's error is handed on to
/// the next interval (error diffusion), so that no sum over neighbors is further than a level from the exact
/// one. Sums and products only: every machine makes the same bytes.
std::array<std::array<std::uint8_t, kIntervals>, 3> observer_levels();

} // namespace metamer
