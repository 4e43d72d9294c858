// Reflectances for sRGB codes.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "color/spectrum.h"
#include "color/xyz.h"

namespace metamer {

/// RRGGBB, six hexadecimal digits; none for anything else.
std::optional<EncodedRgb8> parse_srgb_code(std::string_view text);

/// "ED0A3F".
std::string srgb_code_text(const EncodedRgb8& code);

/// The code of a material under the library's D65: reference_xyz, sRGB's matrix at D65, its curve, 8 bits.
EncodedRgb8 srgb_code_under_d65(const MaterialSpectrum& material);

/// The smoothest reflectance (lhtss) of exactly this code: of the code's own color where one exists, else of
/// a color 0.4 of a code value off it in one to three channels, those toward gray first (white, whose
/// reflectance would be 1 everywhere, and black). None when no such color has one; all of 9845 codes tried,
/// the cube's corners, edges and neighborhood of white among them, have one. Deterministic.
std::optional<MaterialSpectrum> srgb_reflectance(const EncodedRgb8& code);

} // namespace metamer
