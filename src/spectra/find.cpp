#include "base/error.h"
#include "base/names.h"
#include "base/printed.h"
#include "color/resample.h"
#include "spectra/formulas.h"
#include "spectra/library.h"
#include "spectra/sets.h"
#include "spectra/spectrum_file.h"

namespace metamer {

namespace {

// A share of 0 .. 1 in percent with two digits that say something.
std::string percent(double share) {
    if (share < 0.0001)
        return "less than 0.01 %";
    return printed(share < 0.1 ? "%.2f %%" : "%.1f %%", 100 * share);
}

// Refuses a lamp that lights nothing: its peak on the grid is what emissions are divided by.
Lamp with_light(Lamp lamp) {
    constexpr double kLeast = 1e-30;
    if (!(sample_lamp(lamp.spectrum).peak > kLeast))
        throw bad_input("use", lamp.name, "it has no light within 385..700 nm");
    return lamp;
}

void warn_of_loss(const Lamp& lamp, std::vector<std::string>* warnings) {
    constexpr double kRounding = 1e-9;
    const double lost = lost_share(lamp.spectrum, kThesisGrid);
    if (warnings && lost > kRounding)
        warnings->push_back(lamp.name + ": " + percent(lost) +
                            " of its energy lies outside the grid (385..700 nm) and is lost");
}

const Lamp* library_lamp(std::string_view name) {
    for (const Lamp& lamp : library_lamps())
        if (same_name(lamp.name, name))
            return &lamp;
    return nullptr;
}

std::vector<std::string> lamp_names() {
    std::vector<std::string> names;
    for (const Lamp& lamp : library_lamps())
        names.push_back(lamp.name);
    return names;
}

} // namespace

Lamp find_lamp(std::string_view name, const std::string& folder, std::vector<std::string>* warnings) {
    const std::string wanted(trimmed(name));
    if (names_file(wanted)) {
        Lamp lamp = with_light(lamp_from_file(wanted, folder));
        warn_of_loss(lamp, warnings);
        return lamp;
    }
    if (auto lamp = lamp_by_formula(wanted))
        return with_light(std::move(*lamp));
    if (const Lamp* lamp = library_lamp(wanted))
        return *lamp;
    if (library_material(wanted))
        throw bad_input("find", "lamp \"" + wanted + "\"", "it is a material");
    throw bad_input("find", "lamp \"" + wanted + "\"",
                    "the library has no such lamp" + did_you_mean(wanted, lamp_names()));
}

Material find_material(std::string_view name, const std::string& folder, std::vector<std::string>* warnings) {
    const std::string wanted(trimmed(name));
    if (names_file(wanted))
        return material_from_file(wanted, folder, warnings);
    if (auto material = material_by_formula(wanted))
        return std::move(*material);
    if (const Material* material = library_material(wanted))
        return *material;
    if (library_lamp(wanted))
        throw bad_input("find", "material \"" + wanted + "\"", "it is a lamp");
    if (find_material_set(wanted))
        throw bad_input("find", "material \"" + wanted + "\"", "it is a set of materials");
    throw bad_input("find", "material \"" + wanted + "\"",
                    "the library has no such material" + did_you_mean(wanted, material_names()));
}

} // namespace metamer
