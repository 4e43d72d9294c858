// What every atlas must keep, whoever filled it.
#pragma once

#include <optional>
#include <string>

#include "atlas/atlas.h"

namespace metamer {

/// The first thing wrong with an atlas, for people, e.g. "row 0: alpha is not 255"; none when all is well:
/// row 0 is the observer as the atlas's quantization has it, alpha is 255, blue is 0 below row 0, a lamp's
/// greatest value is 255, its peak positive and its k' above 0, a material's scale lies in 0 .. 1, rows
/// without a name are empty, names are good (see flaw_of_name) and not repeated.
std::optional<std::string> flaw_of(const Atlas& atlas);

/// Whether the k' of a lamp of these bytes is above 0: `weighted`, with exact_observer(), which any light
/// has; `thesis`, with the 8-bit observer of row 0, whose y is 0 at 385 .. 415 nm.
bool has_luminance(const Atlas& atlas, const AtlasRow& lamp);

/// What is wrong with the name and source of a row; none when the name is not empty and both are UTF-8
/// without control characters.
std::optional<std::string> flaw_of_name(const std::string& name, const std::string& source);

} // namespace metamer
