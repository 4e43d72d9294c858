// The wavelength grids: evenly spaced, named by first wavelength, step and count.
#pragma once

#include <cstddef>

namespace metamer {

/// Wavelengths first_nm + i * step_nm, i = 0 .. count - 1.
struct Grid {
    double first_nm;
    double step_nm;
    std::size_t count;

    constexpr double wavelength_nm(std::size_t i) const {
        return first_nm + step_nm * static_cast<double>(i);
    }
    constexpr double last_nm() const { return wavelength_nm(count - 1); }
};

/// N of the thesis: the intervals of the atlas and of the loop in the shader.
inline constexpr std::size_t kIntervals = 64;

/// The thesis's grid: 64 intervals of 5 nm, 385 .. 700 nm (DESIGN.md section 1).
inline constexpr Grid kThesisGrid{385.0, 5.0, kIntervals};

/// The reference's grid: 1 nm, 360 .. 830 nm, the range of ISO/CIE 11664-1.
inline constexpr Grid kReferenceGrid{360.0, 1.0, 471};

} // namespace metamer
