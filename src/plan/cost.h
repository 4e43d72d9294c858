// What a pixel costs by each method: the planner's order of trying. Counted in operations, not measured: the
// order must be the same on every machine; `metamer chart` shows how well it agrees with the clock.
#pragma once

#include "plan/object_pixels.h"

namespace metamer {

/// What the cost of a pixel depends on.
struct PixelWork {
    Method method = Method::rgb;
    int taps = 0; ///< of method reduced
    Surface surface = Surface::plain;
    int lamps = 1;
    bool lit = true;
    bool mirrors = true;
};

/// Scalar operations of a pixel, a fetch counted as kFetch of them.
double operations(const PixelWork& work);

/// Scalar operations that a texture fetch costs as much as: llvmpipe's and VideoCore IV's.
inline constexpr double kFetch = 15;

/// Against the same pixel by method rgb as everybody writes it: highlights always, the transfer curve by
/// pow().
double cost_ratio(const PixelWork& work);

} // namespace metamer
