// Method `reduced`: a few wavelengths, chosen and weighted for a scene's own lamps and light.
//
// Where a pixel's spectrum f is not known before the pixel (Beer-Lambert's R T^d with d by the pixel, light
// from one colored wall on another), XYZ = integral of S f cmf / k' must be summed there. A sum over N
// wavelengths with fitted weights does it: quadrature whose points and weights suit this lamp's lines and
// this medium's bands.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "color/colorimetry.h"

namespace metamer {

/// Wavelengths for all lamps of a scene, and per lamp a weight for each: XYZ of light f under lamp l is about
/// the sum over j of weight[l][j] f(wavelength_nm[j]), with Y = 1 for f = 1.
struct Taps {
    std::vector<double> wavelength_nm;    ///< ascending, distinct, each on kReferenceGrid
    std::vector<std::vector<Xyz>> weight; ///< [lamp][tap]
};

/// The counts that the shader is built for.
inline constexpr std::array<int, 7> kTapCounts{4, 6, 8, 12, 16, 24, 32};

/// The best `count` wavelengths found for these lamps, and their weights; exactly `count` of them, those
/// without use with weight 0.
///
/// `lamps`: at least one. `own`: spectra f that matter in this scene, each on kReferenceGrid, 0 .. 1 (samples
/// of what its pixels may hold, e.g. R T^d at a dozen thicknesses for each wall R behind the medium); what is
/// fitted to samples holds between them as long as they are close enough to interpolate. Empty: any material.
/// `count`: 1 .. 64.
///
/// The weights are the least squares over `own`, with errors in CIEDE2000 (tap_problem.h), and over a general
/// ensemble of reflectances, which counts little beside `own` and alone without it. The sum of a lamp's
/// weights is its white, to rounding. They are non-negative without `own`; with it, a channel has negative
/// weights only where they lower its error by more than kWorthNegative. The same input gives the same taps.
Taps choose_taps(std::span<const ReferenceLamp* const> lamps, std::span<const std::vector<double>> own,
                 int count);

/// What negative weights must gain in a channel: root mean square over `own`, in CIEDE2000
/// (ColumnWeights::error).
inline constexpr double kWorthNegative = 0.01;

/// The taps as some of their lamps have them: those of these indices, in that order.
Taps of_lamps(const Taps& taps, std::span<const std::size_t> lamps);

/// The sum itself, in double: XYZ of `light` (on kReferenceGrid) under a lamp by its index.
Xyz taps_xyz(const Taps& taps, std::size_t lamp, std::span<const double> light);

} // namespace metamer
