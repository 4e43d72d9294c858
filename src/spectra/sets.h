// The sets of materials, each built in a file of its own.
#pragma once

#include <string>
#include <vector>

#include "spectra/library.h"

namespace metamer {

/// ColorChecker Classic, 24 measured patches, in the chart's order (colorchecker.csv).
std::vector<Material> colorchecker_materials();

/// Single wavelengths: `single-390` .. `single-700`, one interval of the thesis's grid each: 1 at its
/// wavelength, 0 at its neighbors', linear between. The grid has 64 intervals, a set 63 places: 385 nm, which
/// the observer sees least of, is left out.
std::vector<Material> single_wavelength_materials();

/// The same under `weighted-390` .. `weighted-700`, scaled to equal luminance under illuminant E as far as a
/// reflectance of at most 1 allows: the level is the greatest that more than half of the set (32 of 63)
/// reach; the others, toward the ends of the spectrum, stay at 1.
std::vector<Material> weighted_wavelength_materials();

/// "Empirical" samples: reflectances with several peaks and dips, sums of Gaussian bands; constructed, not
/// measured.
std::vector<Material> empirical_materials();

/// The fifteen crayons' names, without solving for their reflectances.
std::vector<std::string> crayon_names();

/// The crayons, modelled from Crayola's published sRGB colors (crayons.csv, srgb_reflectance).
std::vector<Material> crayon_materials();

/// The media's names, without computing them.
std::vector<std::string> media_names();

/// Absorbing media, glasses and liquids: internal transmittance at the thickness where the strongest
/// absorption on the thesis's grid has density 1 (transmittance 0.1); at d times that, to the power d.
/// Gaussian bands at published positions (transmittance(), absorption.h): computed, not measured.
std::vector<Material> media_materials();

/// The library's material of this name, case aside; none when there is none. Builds no set but the one that
/// has it.
const Material* library_material(std::string_view name);

/// All names of materials, set by set.
std::vector<std::string> material_names();

} // namespace metamer
