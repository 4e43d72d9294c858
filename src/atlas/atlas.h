// The atlas: lamps and materials as rows of a 64 x 64 RGBA8 picture (DESIGN.md section 1).
//
// Column i = interval i of kThesisGrid. Row 0: x, y, z of the observer in R, G, B, divided by the greatest of
// the three. Row r > 0: R = emission of lamp r (its peak = 255), G = reflectance of material r (its scale =
// 255), B = 0 (kept for the fluorescence excitation of material r), A = 255. How the levels are chosen is the
// atlas's Quantization.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "atlas/quantization.h"
#include "color/observer.h"
#include "color/spectrum.h"
#include "spectra/library.h"

namespace metamer {

inline constexpr int kAtlasSize = 64;
inline constexpr int kAtlasRows = kAtlasSize - 1; ///< rows 1 .. 63 hold lamps and materials

/// What a row holds; an empty name means that the row holds none. Names and sources are UTF-8 without control
/// characters; a name is unique among the lamps, or among the materials, case aside.
struct AtlasLamp {
    std::string name, source;
    double peak = 1; ///< the lamp's true greatest value on the grid, in the unit of its source
};
struct AtlasMaterial {
    std::string name, source;
    double scale = 1; ///< reflectance = value / 255 * scale, 0 < scale <= 1; 1 in the thesis's format
};

/// The channels of rows 1 .. 63; in row 0 red, green and blue hold x, y and z.
enum class AtlasChannel : std::size_t { lamp = 0, material = 1, excitation = 2, alpha = 3 };

/// The pixels and what they mean. lamps[0] and materials[0] stay empty: keys are rows.
struct Atlas {
    std::array<std::uint8_t, kAtlasSize * kAtlasSize * 4> rgba{};
    std::array<AtlasLamp, kAtlasSize> lamps;
    std::array<AtlasMaterial, kAtlasSize> materials;
    Quantization quantization = Quantization::thesis; ///< of row 0 and of every row that is added
};

/// The byte of a row, 0 .. 63, and interval, 0 .. 63, in Atlas::rgba.
constexpr std::size_t atlas_byte(int row, std::size_t interval, AtlasChannel channel) {
    return (static_cast<std::size_t>(row) * kAtlasSize + interval) * 4 + static_cast<std::size_t>(channel);
}

/// The bytes of a row's channel, interval by interval.
using AtlasRow = std::array<std::uint8_t, kIntervals>;
AtlasRow atlas_row(const Atlas& atlas, int row, AtlasChannel channel);

/// What the levels of a row stand for: 0 .. 255 as 0 .. `scale`.
std::array<double, kIntervals> row_values(const AtlasRow& row, double scale = 1);

/// An atlas of row 0 only.
Atlas empty_atlas(Quantization quantization = Quantization::weighted);

/// Quantizes in the atlas's way into the first free row; returns its key, 1 .. 63. A name that is already
/// there (case aside) is not added again: its key is returned if its bytes agree (and a material's scale).
/// Throws bad_input if they differ, when all 63 rows are taken, for a name that is empty or holds control
/// characters, and for a lamp whose k' is 0: `weighted`, at 1 nm, 360 .. 830 nm; `thesis`, on the grid with
/// the 8-bit observer.
///
/// `lit_by`: lamps that the material will be seen under, of this atlas already: `weighted` levels then make
/// up for what rounding did to those lamps too; other lamps still count.
int add_lamp(Atlas& atlas, const Lamp& lamp);
int add_material(Atlas& atlas, const Material& material, std::span<const Lamp> lit_by = {});

/// The key of a name (case aside) or, when nothing has that name, of a key written as a number; 0 when there
/// is none.
int find_lamp_key(const Atlas& atlas, std::string_view name_or_key);
int find_material_key(const Atlas& atlas, std::string_view name_or_key);

/// What the shader reads back: row 0, and row `key` (1 .. 63), as numbers 0 .. 1; a reflectance is times its
/// scale.
GridObserver observer(const Atlas& atlas);
Emission emission(const Atlas& atlas, int key);
Reflectance reflectance(const Atlas& atlas, int key);

/// The observer before its levels: sampled_observer() of `thesis`, weighted_observer() of `weighted`. Sums on
/// the CPU take it with emission() and reflectance(); k' of a lamp of the atlas is above 0 with it.
GridObserver exact_observer(const Atlas& atlas);

} // namespace metamer
