// The atlas: lamps and materials as rows of a 64 x 64 RGBA8 picture (DESIGN.md section 1).
//
// Column i = interval i of kThesisGrid. Row 0: x, y, z of the observer in R, G, B, divided by the greatest of the three.
// Row r > 0: R = emission of lamp r (its peak = 255), G = reflectance of material r (1 = 255), B = 0 (kept for the
// fluorescence excitation of material r), A = 255.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "color/observer.h"
#include "color/spectrum.h"
#include "spectra/library.h"

namespace metamer {

inline constexpr int kAtlasSize = 64;
inline constexpr int kAtlasRows = kAtlasSize - 1; ///< rows 1 .. 63 hold lamps and materials

/// What a row holds; an empty name means that the row holds none.
struct AtlasLamp {
    std::string name, source;
    double peak = 1; ///< the lamp's true greatest value on the grid, in the unit of its source
};
struct AtlasMaterial {
    std::string name, source;
    double scale = 1; ///< reflectance = value / 255 * scale; 1 in the thesis's format
};

/// The pixels and what they mean. lamps[0] and materials[0] stay empty: keys are rows.
struct Atlas {
    std::array<std::uint8_t, kAtlasSize * kAtlasSize * 4> rgba{};
    std::array<AtlasLamp, kAtlasSize> lamps;
    std::array<AtlasMaterial, kAtlasSize> materials;
};

/// An atlas of row 0 only.
Atlas empty_atlas();

/// Quantizes in the thesis's way (round half up of value * 255) into the first free row; returns its key. Throws
/// bad_input when all 63 rows are taken. A lamp or material of a name that is already there is not added again.
int add_lamp(Atlas& atlas, const Lamp& lamp);
int add_material(Atlas& atlas, const Material& material);

/// The key of a name (case aside) or of a key written as a number; 0 when there is none.
int find_lamp_key(const Atlas& atlas, std::string_view name_or_key);
int find_material_key(const Atlas& atlas, std::string_view name_or_key);

/// What the shader reads back: row 0 and row `key` as numbers 0 .. 1.
GridObserver observer(const Atlas& atlas);
Emission emission(const Atlas& atlas, int key);
Reflectance reflectance(const Atlas& atlas, int key);

} // namespace metamer
