#include <algorithm>

#include "base/numbers.h"
#include "spectra/absorption.h"
#include "spectra/sets.h"

namespace metamer {

namespace {

struct Medium {
    const char* name;
    const char* what;
    const char* source;                // of the bands' positions
    std::vector<AbsorptionBand> bands; // densities relative to one another
};

constexpr const char* kTextbooks = "textbooks";
constexpr const char* kDye = "the dye's listed maximum in water";

// A band's position is its source's; width and height beside the others are rounded by hand.
const std::vector<Medium>& media() {
    static const std::vector<Medium> table{
        {"glass-cobalt",
         "cobalt-blue glass, Co(II)",
         kTextbooks,
         {{540, 50, 0.55}, {590, 50, 0.90}, {645, 60, 1.00}}},
        {"glass-ruby", "gold-ruby glass, colloidal gold", kTextbooks, {{530, 60, 1.00}, {400, 160, 0.75}}},
        {"glass-chrome",
         "green glass, Cr(III)",
         "Babini et al., Heritage 5 (2022) 1401",
         {{450, 80, 1.00}, {658, 90, 0.80}, {686, 16, 0.15}}},
        {"glass-amber",
         "amber glass, iron and sulfur",
         "Morsi et al., Spectrochimica Acta A 145 (2015) 376",
         {{420, 90, 1.00}, {474, 60, 0.25}}},
        {"glass-neodymium",
         "neodymium glass, Nd(III), narrow bands: another color under every lamp",
         kTextbooks,
         {{585, 18, 1.00},
          {525, 14, 0.45},
          {513, 10, 0.25},
          {475, 16, 0.15},
          {432, 6, 0.10},
          {740, 20, 0.75}}},
        {"liquid-copper", "copper sulfate in water, Cu(II)", kTextbooks, {{810, 240, 1.00}}},
        {"liquid-permanganate",
         "potassium permanganate in water, five steps of one vibration",
         kTextbooks,
         {{526, 90, 0.55},
          {488, 18, 0.15},
          {507, 18, 0.42},
          {526, 18, 0.50},
          {546, 18, 0.50},
          {567, 18, 0.22}}},
        {"liquid-tartrazine", "the food dye tartrazine (E 102) in water", kDye, {{426, 95, 1.00}}},
        {"liquid-allura-red", "the food dye Allura Red AC (E 129) in water", kDye, {{504, 100, 1.00}}},
        {"liquid-brilliant-blue",
         "the food dye Brilliant Blue FCF (E 133) in water",
         kDye,
         {{630, 55, 1.00}}},
    };
    return table;
}

// So that the strongest absorption on the thesis's grid has density 1.
std::vector<AbsorptionBand> at_unit_thickness(std::vector<AbsorptionBand> bands) {
    double most = 0;
    for (std::size_t i = 0; i < kThesisGrid.count; ++i)
        most = std::max(most, density_at(bands, kThesisGrid.wavelength_nm(i)));
    for (AbsorptionBand& band : bands)
        band.density /= most;
    return bands;
}

std::string centers(const std::vector<AbsorptionBand>& bands) {
    std::string text;
    for (const AbsorptionBand& band : bands)
        text += (text.empty() ? "" : ", ") + to_text(band.center_nm);
    return text;
}

} // namespace

std::vector<std::string> media_names() {
    std::vector<std::string> names;
    for (const Medium& medium : media())
        names.emplace_back(medium.name);
    return names;
}

std::vector<Material> media_materials() {
    std::vector<Material> materials;
    for (const auto& [name, what, source, bands] : media())
        materials.push_back({name, std::string(what) + "; computed, not measured",
                             "Gaussian bands at " + centers(bands) + " nm; positions: " + source,
                             transmittance(at_unit_thickness(bands))});
    return materials;
}

} // namespace metamer
