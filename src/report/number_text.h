// Numbers as axes show them.
#pragma once

#include <string>

namespace metamer {

/// A finite number for people: at most `digits` significant digits, no trailing zeros, 1e-4 <= |value| < 1e6
/// written out, beyond that as `2·10⁻⁵` (UTF-8). With U+2212 as its minus.
std::string short_number(double value, int digits = 3);

} // namespace metamer
