// From spectra of any step and range to a grid, keeping energy and centroid.
//
// A curve coarser than the grid is first cut at the grid's wavelengths by linear interpolation. Then every
// sample stands for the energy of its own interval (value times half the distance between its neighbors; at
// an end, times the one distance there), and that energy is shared between the two grid wavelengths beside it
// in inverse proportion to its distance (a hat function): a line between two intervals is shared by both, sum
// and centroid stay. Samples that lie on the grid's wavelengths pass unchanged.
#pragma once

#include <vector>

#include "color/spectrum.h"

namespace metamer {

/// Spectral power per nm on the grid: the sum of result[i] * grid.step_nm is the energy within it. Energy
/// beyond the grid's ends is shared with the end hat as far as that reaches (one step), the rest is left out:
/// see lost_share.
std::vector<double> resample(const LampSpectrum& lamp, const Grid& grid);

/// Reflectance on the grid: the mean of the curve weighted by the hat, its end values held outside its range.
std::vector<double> resample(const MaterialSpectrum& material, const Grid& grid);

/// The share 0 .. 1 of a lamp's radiant energy that resampling leaves out; 0 for a lamp without energy.
double lost_share(const LampSpectrum& lamp, const Grid& grid);

/// A lamp on the thesis's grid, divided by its greatest value, which `peak` receives (0 for a lamp without
/// light there, whose emission is then all 0).
struct SampledLamp {
    Emission emission;
    double peak;
};
SampledLamp sample_lamp(const LampSpectrum& lamp);

/// A material on the thesis's grid, clamped to 0 .. 1.
Reflectance sample_material(const MaterialSpectrum& material);

} // namespace metamer
