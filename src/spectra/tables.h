// The tables of atlas/spectra, built into the program.
#pragma once

#include <string>
#include <string_view>

#include "spectra/csv.h"

namespace metamer {

/// The text of a table, e.g. "crayons.csv". The name must be one that CMakeLists.txt embeds.
std::string table_text(std::string_view file);

/// Read on first use, then kept: cie-illuminants.csv, nist-lamps.csv, krypton-lines.csv,
/// daylight-components.csv, colorchecker.csv.
const SpectrumTable& cie_illuminants();
const SpectrumTable& nist_lamps();
const SpectrumTable& krypton_lines();
const SpectrumTable& daylight_components();
const SpectrumTable& colorchecker();

/// The column of this name; the name must be there.
const Curve& column(const SpectrumTable& table, std::string_view name);

} // namespace metamer
