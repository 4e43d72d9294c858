// What every atlas must keep, whoever filled it.
#pragma once

#include <optional>
#include <string>

#include "atlas/atlas.h"

namespace metamer {

/// A lamp's peak. Wider than what lamps are made of (1e-30 .. 1e30: spectra/csv.h, find_lamp), and far from
/// where sums and squares over a spectrum end in 0 or infinity.
inline constexpr double kLeastPeak = 1e-35, kGreatestPeak = 1e35;

/// The first thing wrong with an atlas, for people, e.g. "row 0: alpha is not 255"; none when all is well:
/// row 0 is the observer as the atlas's quantization has it, alpha is 255, blue is 0 below row 0, a lamp's
/// greatest value is 255, its peak in range and its k' above 0, a material's scale lies in 0 .. 1, rows
/// without a name are empty, names are good (see flaw_of_name) and not repeated.
std::optional<std::string> flaw_of(const Atlas& atlas);

/// Whether the k' of a lamp of these bytes is above 0: `weighted`, with exact_observer(), which any light
/// has; `thesis`, with the 8-bit observer of row 0, whose y is 0 at 385 .. 415 nm.
bool has_luminance(const Atlas& atlas, const AtlasRow& lamp);

/// What is wrong with the name and source of a row; none when the name is not empty and both are UTF-8
/// without control characters.
std::optional<std::string> flaw_of_name(const std::string& name, const std::string& source);

} // namespace metamer
