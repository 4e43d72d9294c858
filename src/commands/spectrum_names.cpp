#include "commands/spectrum_names.h"

#include <filesystem>

#include "base/names.h"
#include "spectra/csv.h"
#include "spectra/library.h"
#include "spectra/spectrum_file.h"

namespace metamer {

namespace {

bool is_whole_file(const std::string& name) {
    std::error_code ec; // a name that cannot be asked for is refused where it is read
    return names_file(name) && name.find('#') == std::string::npos &&
           std::filesystem::is_regular_file(name, ec);
}

void add_columns(std::vector<std::string>& out, const std::string& path, SpectrumKind kind) {
    for (const std::string& column : read_spectra(path, kind).names)
        out.push_back(path + "#" + column);
}

} // namespace

std::vector<std::string> expanded_lamps(std::span<const std::string> names) {
    std::vector<std::string> out;
    for (const std::string& name : names)
        if (is_whole_file(name))
            add_columns(out, name, SpectrumKind::emission);
        else if (same_name(name, "thesis"))
            out.insert(out.end(), thesis_lamps().begin(), thesis_lamps().end());
        else if (same_name(name, "all"))
            for (const Lamp& lamp : library_lamps())
                out.push_back(lamp.name);
        else
            out.push_back(name);
    return out;
}

std::vector<std::string> expanded_materials(std::span<const std::string> names) {
    std::vector<std::string> out;
    for (const std::string& name : names) {
        const MaterialSet* set = find_material_set(name);
        if (is_whole_file(name))
            add_columns(out, name, SpectrumKind::reflectance);
        else if (set)
            out.insert(out.end(), set->materials.begin(), set->materials.end());
        else
            out.push_back(name);
    }
    return out;
}

} // namespace metamer
