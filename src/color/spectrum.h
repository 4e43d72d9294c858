// Spectra: as measured or computed (any step, lines apart), and as sampled on the thesis's grid.
#pragma once

#include <array>
#include <vector>

#include "color/grid.h"

namespace metamer {

/// A piecewise linear function of wavelength. wavelength_nm ascends strictly; both have the same length, at
/// least 2.
struct Curve {
    std::vector<double> wavelength_nm;
    std::vector<double> value;
};

/// A curve's value by linear interpolation, the nearest end's value beyond its ends.
double value_at_held(const Curve& curve, double wavelength_nm);

/// The curve through these values times `scale` on kThesisGrid.
Curve curve_of(const std::array<double, kIntervals>& values, double scale = 1);

/// All of `power` at one wavelength; power is in the units of the continuum times nm.
struct EmissionLine {
    double wavelength_nm;
    double power;
};

/// What a lamp emits, in relative spectral power: a continuum (may be empty; 0 outside its range) plus lines.
struct LampSpectrum {
    Curve continuum;
    std::vector<EmissionLine> lines;
};

/// What a material reflects, 0 .. 1 per wavelength, its end values held outside its range.
struct MaterialSpectrum {
    Curve curve;
};

/// 64 values on kThesisGrid; the tag keeps an emission from being taken for a reflectance.
template <class Meaning>
struct Sampled {
    std::array<double, kIntervals> value{};
};
using Emission = Sampled<struct EmissionMeaning>;
using Reflectance = Sampled<struct ReflectanceMeaning>;

} // namespace metamer
