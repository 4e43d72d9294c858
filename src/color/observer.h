// The CIE 1931 2-degree standard colorimetric observer.
#pragma once

#include <array>
#include <span>

#include "color/grid.h"

namespace metamer {

/// One row of the table: color matching functions at a wavelength.
struct ColorMatching {
    double x, y, z;
};

/// ISO/CIE 11664-1:2019 (CIE 018 table), 1 nm, 360 .. 830 nm: one row per wavelength of kReferenceGrid.
std::span<const ColorMatching, kReferenceGrid.count> cie_1931_2deg();

/// Color matching functions sampled on kThesisGrid.
struct GridObserver {
    std::array<double, kIntervals> x{}, y{}, z{};
};

/// The observer's values at the grid's wavelengths, divided by the greatest of all (1.7826, z at 445 nm):
/// what row 0 of the atlas holds before rounding. The division cancels in X'/k'.
GridObserver sampled_observer();

/// Weights in place of samples, as ASTM E308-18 section 7 forms them from the 1 nm table: what lies between
/// two of the grid's wavelengths is shared by both in inverse proportion to the distance (light and
/// reflectance are taken as linear in between), and everything outside 385 .. 700 nm counts for the grid's
/// end on its side. The sums over the grid are those of the table, 360 .. 830 nm; divided by the greatest
/// weight of all (z at 445 nm), which cancels in X'/k'. All y are above 0.
GridObserver weighted_observer();

/// The weight 0 .. 1 of a wavelength for each of the grid's intervals, at most two of them not 0: the share
/// 1 - `share_of_next` goes to `interval`, the rest to the one after it; outside the grid all to its end.
struct HatShare {
    std::size_t interval; ///< 0 .. 62
    double share_of_next; ///< 0 .. 1
};
HatShare hat_share(double wavelength_nm);

} // namespace metamer
