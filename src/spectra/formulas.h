// Lamps and materials by formula: `planck:2856`, `daylight:5000`, `gauss:530:20`, `line:589.3`, `rgb:ED0A3F`,
// `absorb:590:50:1`.
#pragma once

#include <optional>
#include <string_view>

#include "spectra/library.h"

namespace metamer {

/// The lamp of a formula: planck:KELVIN (500..100000), daylight:KELVIN (4000..25000), gauss:CENTER:FWHM
/// (360..830 nm, 0.1..500 nm), line:NM (360..830). None for a name that has no colon. Throws bad_input for an
/// unknown formula, a number out of its range, the wrong count of numbers, and for `rgb:` and `absorb:`,
/// which make materials.
std::optional<Lamp> lamp_by_formula(std::string_view name);

/// The material of a formula: gauss:CENTER:FWHM (peak 1), rgb:RRGGBB, and absorb:CENTER:FWHM:DENSITY, an
/// absorbing medium's internal transmittance at thickness 1 (absorption.h; density 0..10); three numbers more
/// for each further band. Likewise; planck, daylight and line make lamps.
std::optional<Material> material_by_formula(std::string_view name);

} // namespace metamer
