// Atlases as PNG files: names, sources, peaks and scales travel as text chunks.
#pragma once

#include <filesystem>
#include <string>

#include "atlas/atlas.h"
#include "image/png.h"

namespace metamer {

/// The PNG of an atlas; byte for byte the same for the same atlas.
std::string encode_atlas(const Atlas& atlas);

/// Reads an atlas; `place` is the file's name for errors. Throws bad_input for a PNG that is no atlas: other size,
/// palette or 16-bit, truncated at any byte, row 0 not the observer, text chunks missing or contradictory.
Atlas decode_atlas(const std::string& bytes, const std::string& place);
Atlas read_atlas(const std::filesystem::path& path);

} // namespace metamer
