// Tristimulus integration at full resolution: the project's reference.
#pragma once

#include <span>

#include "color/spectrum.h"
#include "color/xyz.h"

namespace metamer {

/// A lamp resampled to kReferenceGrid together with its k' = sum of S y. Throws bad_input for a lamp without
/// any light the observer sees (k' = 0).
struct ReferenceLamp {
    std::vector<double> power;
    double k;
};
ReferenceLamp reference_lamp(const LampSpectrum& lamp);

/// XYZ of a material under a lamp, double precision, 1 nm, 360 .. 830 nm, Y = 1 for the perfect reflector
/// under that lamp (CIE 15:2018 section 7.1; equations 7.1, 7.6-7.10 of the thesis at I_source I_shading =
/// 1). `reflectance`: one value per wavelength of kReferenceGrid, as resample(material, kReferenceGrid)
/// gives.
Xyz reference_xyz(const ReferenceLamp& lamp, std::span<const double> reflectance);
Xyz reference_xyz(const LampSpectrum& lamp, const MaterialSpectrum& material);

/// XYZ of the lamp itself, Y = 1: the perfect reflector under it.
Xyz reference_white(const ReferenceLamp& lamp);
Xyz reference_white(const LampSpectrum& lamp);

/// x, y of X, Y, Z; (0, 0) for black.
Chromaticity chromaticity(const Xyz& c);

/// XYZ of chromaticity x, y at Y = 1. y must not be 0.
Xyz xyz_of(const Chromaticity& c);

} // namespace metamer
