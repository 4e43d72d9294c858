// What holds for every exhibit that was loaded.
#pragma once

#include "exhibit/exhibit.h"

namespace metamer::fuzz {

/// Aborts (must.h) unless numbers are within the ranges of the table of keys, keys name rows of the atlas,
/// spectra are finite, maps are such as textures can be, and each half can be seen.
void check_exhibit(const Exhibit& exhibit);

} // namespace metamer::fuzz
