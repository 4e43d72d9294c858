// The library of named lamps and materials, and every other way that a name stands for a spectrum.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "color/spectrum.h"

namespace metamer {

/// A lamp with its name and where its figures come from.
struct Lamp {
    std::string name;        ///< e.g. "F11", "planck:2856", "my-lamp.csv#tube"
    std::string description; ///< for people: "CIE F11, narrow-band fluorescent"; says "modelled" or
                             ///< "computed" if it is
    std::string source;      ///< provenance: standard and table, formula, or file
    LampSpectrum spectrum;
};

/// A material, likewise.
struct Material {
    std::string name;
    std::string description;
    std::string source;
    MaterialSpectrum spectrum;
};

/// A named list of at most 63 materials: one atlas's worth.
struct MaterialSet {
    std::string name; ///< "colorchecker", "single", "weighted", "empirical", "crayons", "media"
    std::string description;
    std::vector<std::string> materials;
};

/// All named lamps: the thesis's fifteen first, in its order, then the CIE set, then the NIST set. At
/// most 63.
std::span<const Lamp> library_lamps();

/// The names of the thesis's fifteen lamps (figures 45-46), in its order.
std::span<const std::string> thesis_lamps();

/// All named materials, set by set.
std::span<const Material> library_materials();
std::span<const MaterialSet> material_sets();

/// The set of this name; none when there is none.
const MaterialSet* find_material_set(std::string_view name);

/// A lamp by library name (case aside), by formula (`planck:2856`, `daylight:5000`, `gauss:530:20`,
/// `line:589.3`) or by file (`path.csv`, `path.csv#column`; relative paths are taken from `folder`). Throws
/// bad_input that names the nearest library name, the range a formula's number must keep, or what is wrong in
/// the file and where. `warnings`, if given, receives one sentence per doubt (energy outside the grid, with
/// the lost share).
Lamp find_lamp(std::string_view name, const std::string& folder = ".",
               std::vector<std::string>* warnings = nullptr);

/// A material likewise; formulas: `gauss:530:20` (peak 1), `rgb:ED0A3F` (the smoothest reflectance with
/// exactly this sRGB color under D65) and `absorb:590:50:1` (transmittance of an absorbing medium).
Material find_material(std::string_view name, const std::string& folder = ".",
                       std::vector<std::string>* warnings = nullptr);

} // namespace metamer
