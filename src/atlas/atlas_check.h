// What every atlas must keep, whoever filled it.
#pragma once

#include <optional>
#include <string>

#include "atlas/atlas.h"

namespace metamer {

/// The first thing wrong with an atlas, for people, e.g. "row 0 is not the CIE 1931 observer"; none when all
/// is well: row 0 is the quantized observer, alpha is 255, blue is 0 below row 0, a lamp's greatest value is
/// 255, its peak positive and its k' above 0, a material's scale lies in 0 .. 1, rows without a name are
/// empty, names are good (see flaw_of_name) and not repeated.
std::optional<std::string> flaw_of(const Atlas& atlas);

/// Whether a lamp of these bytes has any light where the atlas's own observer has y > 0: its k' is not 0.
/// Violet lines (385 .. 415 nm) have none, as 8 bits round y to 0 there.
bool has_luminance(const Atlas& atlas, const AtlasRow& lamp);

/// What is wrong with the name and source of a row; none when the name is not empty and both are UTF-8
/// without control characters.
std::optional<std::string> flaw_of_name(const std::string& name, const std::string& source);

} // namespace metamer
