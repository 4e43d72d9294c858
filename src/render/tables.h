// Textures of numbers that shaders look up: what each key of a map stands for, taps, packed wavelengths.
#pragma once

#include <array>
#include <vector>

#include "image/png.h"
#include "plan/planner.h"

namespace metamer {

/// A number of 0 .. 1 as two bytes, high and low; clamped.
std::array<std::uint8_t, 2> two_bytes(double share);

/// The three numbers of every material of the atlas for a product method, as 2 x 64 texels: high and low byte
/// of a 16-bit code over kMaterialMapLeast .. + kMaterialMapSpan, clamped to it.
Image product_table(Method method, const ExhibitSpectra& spectra, const OutputSpace& output);

/// The scale of every material's reflectance, as 2 x 64 texels: high and low byte in all three channels.
Image scale_table(const Atlas& atlas);

/// What each lamp makes of each key: linear RGB, strength in it; 2 texels per lamp and row (16 x 64), as
/// codes over the lamp's range, least and span, which `ranges` receives.
struct FoldedTable {
    Image image;
    std::vector<std::array<double, 2>> ranges;
};
FoldedTable folded_table(const HalfView& view, const ExhibitSpectra& spectra);

/// The reflectance of every key at every tap: 32 x 64, high byte in R, low byte in G.
Image tap_reflectances(const ExhibitSpectra& spectra, const Taps& taps);

/// Taps of several lamps, 32 x 32: column = tap; rows 2 l and 2 l + 1 high and low byte of lamp l's linear
/// RGB over ranges[l]; rows 16 and 17 of what the taps share, over `layer_range`.
struct TapTable {
    Image image;
    std::vector<std::array<double, 2>> ranges;
    std::array<double, 2> layer_range{};
};
TapTable tap_table(const std::vector<std::vector<std::array<double, 3>>>& colors,
                   const std::vector<double>& layers);

/// The atlas with four wavelengths per texel (variants.h: kPackedColumns x kPackedRows).
Image packed_atlas(const Atlas& atlas);

/// Thresholds of ordered dithering, 8 x 8 (Bayer 1973), (k + 1/2) / 64 in every channel.
Image dither_table();

} // namespace metamer
