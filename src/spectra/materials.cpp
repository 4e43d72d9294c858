#include "base/names.h"
#include "spectra/sets.h"
#include "spectra/tables.h"

namespace metamer {

namespace {

// A set's materials, built on first use. A function of its own per set gives each its own static.
template <std::vector<Material> (*build)()>
const std::vector<Material>& kept() {
    static const std::vector<Material> materials = build();
    return materials;
}

struct Recipe {
    MaterialSet set;
    const std::vector<Material>& (*materials)();
};

template <std::vector<Material> (*build)()>
std::vector<std::string> names_of() {
    std::vector<std::string> names;
    for (const Material& material : kept<build>())
        names.push_back(material.name);
    return names;
}

const std::vector<Recipe>& recipes() {
    static const std::vector<Recipe> all{
        {{"colorchecker", "ColorChecker Classic, 24 patches, measured", colorchecker().names},
         kept<colorchecker_materials>},
        {{"single", "single wavelengths, one interval of 5 nm each, 390..700 nm",
          names_of<single_wavelength_materials>()},
         kept<single_wavelength_materials>},
        {{"weighted", "single wavelengths at equal luminance under E where a reflectance of 1 allows it",
          names_of<weighted_wavelength_materials>()},
         kept<weighted_wavelength_materials>},
        {{"empirical", "samples with several peaks and dips, constructed, not measured",
          names_of<empirical_materials>()},
         kept<empirical_materials>},
        {{"crayons", "fifteen crayons, modelled from Crayola's published sRGB colors; no measurement",
          crayon_names()},
         kept<crayon_materials>},
        {{"media",
          "colored glasses and liquids: internal transmittance, computed from published band positions; "
          "density 1 "
          "at thickness 1",
          media_names()},
         kept<media_materials>},
    };
    return all;
}

} // namespace

std::span<const MaterialSet> material_sets() {
    static const std::vector<MaterialSet> sets = [] {
        std::vector<MaterialSet> out;
        for (const Recipe& recipe : recipes())
            out.push_back(recipe.set);
        return out;
    }();
    return sets;
}

const MaterialSet* find_material_set(std::string_view name) {
    for (const MaterialSet& set : material_sets())
        if (same_name(set.name, trimmed(name)))
            return &set;
    return nullptr;
}

std::span<const Material> library_materials() {
    static const std::vector<Material> all = [] {
        std::vector<Material> out;
        for (const Recipe& recipe : recipes())
            out.insert(out.end(), recipe.materials().begin(), recipe.materials().end());
        return out;
    }();
    return all;
}

const Material* library_material(std::string_view name) {
    for (const Recipe& recipe : recipes())
        for (std::size_t i = 0; i < recipe.set.materials.size(); ++i)
            if (same_name(recipe.set.materials[i], name))
                return &recipe.materials()[i];
    return nullptr;
}

std::vector<std::string> material_names() {
    std::vector<std::string> names;
    for (const Recipe& recipe : recipes())
        names.insert(names.end(), recipe.set.materials.begin(), recipe.set.materials.end());
    return names;
}

} // namespace metamer
