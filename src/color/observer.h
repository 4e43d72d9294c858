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

} // namespace metamer
