// Atlases as PNG files: names, sources, peaks and scales travel as text chunks (atlas_text.h).
#pragma once

#include <filesystem>
#include <string>

#include "atlas/atlas.h"

namespace metamer {

/// The PNG of an atlas; byte for byte the same for the same atlas. Throws bad_input for an atlas with a flaw
/// (flaw_of), so that whatever is written can be read.
std::string encode_atlas(const Atlas& atlas);

/// Reads an atlas; `place` is the file's name for errors. Throws bad_input for a PNG that is no atlas: other
/// size, palette, gray or 16-bit, truncated at any byte, row 0 not the observer, text chunks missing or
/// contradictory.
Atlas decode_atlas(const std::string& bytes, const std::string& place);

/// Reads an atlas file of at most 4 MiB: 63 rows with the longest names that make sense take a hundredth of
/// that.
Atlas read_atlas(const std::filesystem::path& path);

} // namespace metamer
