// Spectra from CSV files.
#pragma once

#include <string>
#include <vector>

#include "color/spectrum.h"

namespace metamer {

/// One file of spectra over a common column of wavelengths.
struct SpectrumTable {
    std::string title;              ///< first comment line, or empty
    std::string source;             ///< `# source: ...`, or empty
    std::string unit;               ///< `# unit: ...`, or empty
    std::vector<std::string> names; ///< one per column after the first
    std::vector<Curve> curves;      ///< same length as names
};

/// What the values are: powers (any scale, >= 0), reflectances (0 .. 1, or 0 .. 100 if the unit says
/// percent), or parts of a sum, which may be negative (CIE daylight's S1 and S2).
enum class SpectrumKind { emission, reflectance, component };

/// Reads CSV text: comment lines start with `#`; a header `wavelength_nm,NAME,...` (optional for two columns,
/// which then take the file's name); then rows, wavelengths ascending strictly, at any step. Names may stand
/// in double quotes; blanks at their ends go.
///
/// Units: the header's first cell names the wavelength's: nm, or um and angstrom, which are converted (no
/// unit is nm). Refused by name: wavenumbers and frequencies; a `# unit:` of micrometers or angstroms under a
/// header that names no unit; photon counts; a lamp in reflectance, a material in watts. Reflectances up to 1
/// + 1e-6 count as 1.
///
/// `place` is the file's name for errors, to which they add the line: negative value, NaN or infinity, value
/// above 1e30, unsorted or repeated wavelengths, wavelengths outside 100 .. 5000 nm, fewer than two points,
/// an empty file, a wrong separator (`;`, tab, blanks), a decimal comma, a ragged row, names missing or used
/// twice.
SpectrumTable parse_spectra(const std::string& text, const std::string& place, SpectrumKind kind);

/// The same from a file of at most 16 MiB.
SpectrumTable read_spectra(const std::string& path, SpectrumKind kind);

} // namespace metamer
