// RGB working spaces: primaries and white give the matrix, the one way that matrices are built here.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "color/matrix3.h"

namespace metamer {

/// An RGB space by the chromaticities of its primaries and its white.
struct WorkingSpace {
    std::string_view name;        ///< as INI files and `list spaces` write it, e.g. "sRGB-D65"
    std::string_view description; ///< for people
    Chromaticity red, green, blue, white;
    std::string_view white_illuminant; ///< the library's lamp of that white: D65, D50, E, C
};

/// The eight working spaces of the thesis's figure 33, white swapped without adaptation as there, plus Apple
/// RGB at D65 (whose matrix figure 33 prints under the name "Apple (D50)"). The first is the default:
/// sRGB-D65. Primaries: IEC 61966-2-1 (sRGB), CIE 1931 RGB, Adobe RGB (1998), Apple RGB, NTSC 1953, ITU-R
/// BT.470 PAL/SECAM; whites: CIE 15, rounded as those standards round them.
std::span<const WorkingSpace> working_spaces();

/// The space of this name, case and blanks aside ("srgb d65" is "sRGB-D65"); none when there is none.
const WorkingSpace* find_working_space(std::string_view name);

/// XYZ of linear RGB: columns are the primaries, scaled so that R = G = B = 1 is the white at Y = 1
/// (SMPTE RP 177-1993, section 3.3). None when the primaries lie on a line.
std::optional<Matrix3> xyz_from_rgb(const WorkingSpace& space);

/// Its inverse: M_space of DESIGN.md section 1. Throws bad_input for primaries on a line.
Matrix3 rgb_from_xyz(const WorkingSpace& space);

} // namespace metamer
