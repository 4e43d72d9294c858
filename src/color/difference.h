// Color differences.
#pragma once

#include "color/matrix3.h"
#include "color/xyz.h"

namespace metamer {

/// CIE 1976 L*a*b*.
struct Lab {
    double l{}, a{}, b{};
};

/// The white of CIELAB for every figure in this project: the display's, D65 (x = 0.3127, y = 0.3290), which
/// is what a visitor before a screen is adapted to.
Xyz display_white();

/// CIELAB of XYZ against a white, both with the same scale of Y (ISO/CIE 11664-4:2019).
Lab lab(const Xyz& c, const Xyz& white);

/// CIEDE2000 with kL = kC = kH = 1 (ISO/CIE 11664-6:2014; Sharma, Wu, Dalal 2005 for the hue's branches).
double delta_e_2000(const Lab& a, const Lab& b);

/// CIEDE2000 of two colors seen on the display: delta_e_2000(lab(a, display_white()), lab(b,
/// display_white())).
double delta_e_2000(const Xyz& a, const Xyz& b);

/// How a small change of XYZ is seen: the matrix J for which delta_e_2000(c, c + d) tends to |J d| for small
/// d, both seen on the display. The rows are CIEDE2000's terms of lightness, of chroma with its share of the
/// rotation, and of hue; at a gray, where hue is open, a and b stand for chroma and hue.
Matrix3 delta_e_2000_slopes(const Xyz& c);

} // namespace metamer
