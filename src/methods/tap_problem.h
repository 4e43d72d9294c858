// What taps are fitted to: spectra, their XYZ under each lamp, and how visible an error in each is.
#pragma once

#include <span>
#include <vector>

#include "color/colorimetry.h"

namespace metamer {

/// Rows are spectra; columns are the lamps' channels: X, Y, Z of the first lamp, of the second, ...
struct TapProblem {
    std::size_t rows, columns;
    std::vector<std::span<const double>> spectrum; ///< [row], on kReferenceGrid; `own` and static data: views
    std::vector<double> target;                    ///< [row * columns + column], white = 1 in Y
    std::vector<double> visible; ///< likewise: CIEDE2000 per unit of error, times the row's share
    std::vector<double> white;   ///< [column], of f = 1: to be met exactly
};

/// The least-squares problem of these lamps and spectra. An own row's share is 1 / sqrt(count of own rows),
/// so that the sum of squares is a mean; an error in a channel is weighed by what CIEDE2000 makes of it at
/// that color (delta_e_2000_slopes): dark and grayish colors count more than bright and vivid ones. The
/// general ensemble is weighed as a gray of 25 % is, and by kGeneralShare if there are own rows. `own` must
/// outlive the problem.
TapProblem tap_problem(std::span<const ReferenceLamp* const> lamps, std::span<const std::vector<double>> own);

/// The general ensemble's weight beside `own`.
inline constexpr double kGeneralShare = 0.03;

/// Reflectances in general, as deviations from gray: cosines over 360 .. 830 nm of k = 1 .. 64 half-waves and
/// amplitude 0.2 / (1 + (k / 2.5)^2). Their summed squared error is the expected one for a Gaussian random
/// reflectance of that spectral density, which is a Matern process of smoothness 3/2 (Rasmussen, Williams,
/// "Gaussian Processes for Machine Learning", 2006, eq. 4.15). It follows what was measured of CIE's 99 color
/// evaluation samples (standard deviations 0.18, 0.10, 0.045, 0.012, 0.0021, 0.0005 at k = 1, 2, 4, 8, 16,
/// 32) and is rougher at the end, for bands as narrow as 16 nm.
std::span<const std::vector<double>> general_ensemble();

} // namespace metamer
