// An atlas in words and numbers: for people, and as JSON.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "atlas/atlas.h"

namespace metamer {

/// A table for a terminal (UTF-8, each line ends with a line feed): the observer, the quantization, then
/// every row that holds something: its key, lamp and material with the lamp's peak, a material's scale where
/// it is not 1, and their curves in 32 columns of block characters, each the greater of two intervals, in
/// eighths of full scale (0 is a blank).
std::string describe(const Atlas& atlas);

/// {"rows": [{"key", "lamp": {"name", "peak", "source"}, "material": {"name", "scale", "source"}}],
/// "observer", "quantization", "grid": {"first_nm", "step_nm", "count"}}: the rows that hold something,
/// `null` for the one that a row has not.
nlohmann::json describe_json(const Atlas& atlas);

} // namespace metamer
