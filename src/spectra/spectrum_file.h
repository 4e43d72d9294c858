// Lamps and materials from files: `path.csv`, `path.csv#column`.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "spectra/library.h"

namespace metamer {

/// Whether a name is meant as a path: it has a `/`, or ends in .csv or .txt (before `#column`), case aside.
bool names_file(std::string_view name);

/// That path, without `#column`; empty where the name is not meant as one.
std::string path_named(std::string_view name);

/// The spectrum of a file (read_spectra). Without `#column` the file must hold one spectrum. Relative paths
/// are taken from `folder`. The name is kept as typed. Throws bad_input for what read_spectra refuses, and
/// for a column that is missing or left open, naming the columns that there are.
Lamp lamp_from_file(std::string_view name, const std::string& folder);

/// Likewise; `warnings`, if given, receives a sentence when the file leaves out part of 400..700 nm, where
/// its end values are then held.
Material material_from_file(std::string_view name, const std::string& folder,
                            std::vector<std::string>* warnings);

} // namespace metamer
