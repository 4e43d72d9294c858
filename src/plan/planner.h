// The planner: for each object of each half the cheapest method that keeps the exhibit's tolerance, and why.
#pragma once

#include <string>
#include <vector>

#include "plan/object_pixels.h"

namespace metamer {

/// Mantissa bits of IEEE 754 binary32 and binary16.
inline constexpr int kSingleBits = 23, kHalfBits = 10;

/// Fragment shaders with fewer mantissa bits than this count as half precision.
inline constexpr int kFloatBits = 16;

/// shade_xyz() in the precision that stands for fragment shaders of so many bits: Float16 or float.
Xyz shown_xyz(Method method, const Pixel& pixel, const Sight& sight, int fragment_bits);

/// How one object is drawn in one half.
struct ObjectPlan {
    std::string object;
    Method method = Method::folded;
    Taps taps;          ///< of method reduced, for the half's lamps in their order
    bool asked = false; ///< the exhibit says so; else the planner chose
    Reason why;
    double delta_e_bound = 0; ///< the greatest CIEDE2000 over pixels_of() against exact_xyz()
    PixelName worst;          ///< the pixel of that
    double cost_ratio = 1;    ///< counted (cost.h), to rgb as everybody writes it
};

struct HalfPlan {
    HalfView view;
    std::vector<ObjectPlan> objects; ///< in the exhibit's order
};

struct Plan {
    double tolerance = 0.5;
    int fragment_bits = kSingleBits; ///< what the shaders compute with
    std::vector<HalfPlan> halves;
};

/// Plans every object of every half. `fragment_bits`: as measured by gles/precision_probe.h. Where `auto` was
/// asked for and no method keeps the tolerance: bad_input, naming the object, the nearest method, its error
/// and its worst pixel. A method that was asked for is taken whatever its error, unless it cannot draw the
/// object (folded through a medium of varying thickness): bad_input.
Plan plan_exhibit(const Exhibit& exhibit, const ExhibitSpectra& spectra, int fragment_bits = kSingleBits);

} // namespace metamer
