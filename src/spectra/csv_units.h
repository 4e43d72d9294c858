// What a spectrum file says of its units, in its header and in its `# unit:` line.
#pragma once

#include <string>
#include <string_view>

#include "spectra/csv.h"

namespace metamer {

/// Whether a header's first cell stands for wavelengths: it names a unit of wavelength, or begins with
/// "wave", "lambda", "wl" or the Greek letter.
bool is_wavelength_header(std::string_view cell);

/// Nanometers per unit of wavelength: 1 (nm, or nothing named), 1000 (um, micron, micrometer), 0.1
/// (angstrom). `header` is the first cell, empty if there is no header. Throws bad_input for wavenumbers,
/// frequencies and electron volts in either text, and for a `# unit:` of micrometers or angstroms that a
/// header without a unit leaves open.
double nm_per_unit(std::string_view header, std::string_view unit_line, const std::string& place);

/// What to multiply values by: 0.01 for reflectances in percent, 1 otherwise. Throws bad_input for a `#
/// unit:` that cannot be for this kind: photon counts, a lamp in reflectance, a material in watts.
double value_scale(std::string_view unit_line, SpectrumKind kind, const std::string& place);

} // namespace metamer
