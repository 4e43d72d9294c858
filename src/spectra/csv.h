// Spectra from CSV files.
#pragma once

#include <string>
#include <vector>

#include "color/spectrum.h"

namespace metamer {

/// One file of spectra over a common column of wavelengths.
struct SpectrumTable {
    std::string title;                 ///< first comment line, or empty
    std::string source;                ///< `# source: ...`, or empty
    std::string unit;                  ///< `# unit: ...`, or empty
    std::vector<std::string> names;    ///< one per column after the first
    std::vector<Curve> curves;         ///< same length as names
};

/// Whether values are powers (any scale, >= 0) or reflectances (0 .. 1, or 0 .. 100 if the unit says percent).
enum class SpectrumKind { emission, reflectance };

/// Reads CSV text: comment lines start with `#`; a header `wavelength_nm,NAME,...` (optional for two columns); then
/// rows, wavelengths ascending strictly, at any step. A `# unit:` that names micrometers, angstroms or wavenumbers is
/// converted or refused by name; see docs. `place` is the file's name for errors, which add the line:
/// negative value, NaN or infinity, unsorted or repeated wavelengths, fewer than two points, an empty file, a wrong
/// separator (`;`, tab, decimal comma), a ragged row, a unit that cannot be, wavelengths that cannot be nanometers.
SpectrumTable parse_spectra(const std::string& text, const std::string& place, SpectrumKind kind);
SpectrumTable read_spectra(const std::string& path, SpectrumKind kind);

} // namespace metamer
