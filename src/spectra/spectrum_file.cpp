#include "spectra/spectrum_file.h"

#include <algorithm>
#include <filesystem>

#include "base/error.h"
#include "base/names.h"
#include "base/numbers.h"
#include "spectra/csv.h"

namespace metamer {

namespace {

struct Place {
    std::string path, column; // no column: empty
};

bool has_table_ending(std::string_view path) {
    const std::string low = lower_case(path);
    return low.ends_with(".csv") || low.ends_with(".txt");
}

// The `#` that begins the column is the last one after an ending that tables have; a path without such an
// ending may hold no other `#`.
Place take_apart(std::string_view name) {
    for (std::size_t at = name.rfind('#'); at != std::string_view::npos && at > 0;
         at = name.rfind('#', at - 1))
        if (has_table_ending(name.substr(0, at)))
            return {std::string(name.substr(0, at)), std::string(trimmed(name.substr(at + 1)))};
    const std::size_t at = name.rfind('#');
    if (has_table_ending(name) || at == std::string_view::npos)
        return {std::string(name), {}};
    return {std::string(name.substr(0, at)), std::string(trimmed(name.substr(at + 1)))};
}

struct Found {
    Curve curve;
    std::string column, title, source;
};

Found find_in_file(std::string_view name, const std::string& folder, SpectrumKind kind) {
    const Place place = take_apart(name);
    const std::string path = (std::filesystem::path(folder) / place.path).lexically_normal().string();
    SpectrumTable table = read_spectra(path, kind);
    std::size_t at = 0;
    if (place.column.empty() && table.names.size() > 1)
        throw bad_input("read", path, "it holds several spectra; add #COLUMN, one of " + listed(table.names));
    if (!place.column.empty())
        while (at < table.names.size() && !same_name(table.names[at], place.column))
            ++at;
    if (at == table.names.size())
        throw bad_input("read", path,
                        "it has no column `" + place.column + "`, only " + listed(table.names) +
                            did_you_mean(place.column, table.names));
    return {std::move(table.curves[at]), table.names[at], table.title, table.source};
}

std::string description_of(const Found& found) {
    return found.title.empty() ? found.column + ", from a file" : found.column + ": " + found.title;
}

std::string source_of(const Found& found, std::string_view name) {
    return found.source.empty() ? std::string(name) : found.source;
}

} // namespace

bool names_file(std::string_view name) {
    return name.find('/') != std::string_view::npos || has_table_ending(take_apart(name).path);
}

std::string path_named(std::string_view name) {
    return names_file(name) ? take_apart(name).path : std::string();
}

Lamp lamp_from_file(std::string_view name, const std::string& folder) {
    Found found = find_in_file(name, folder, SpectrumKind::emission);
    return {std::string(name), description_of(found), source_of(found, name), {std::move(found.curve), {}}};
}

Material material_from_file(std::string_view name, const std::string& folder,
                            std::vector<std::string>* warnings) {
    Found found = find_in_file(name, folder, SpectrumKind::reflectance);
    const double first = found.curve.wavelength_nm.front(), last = found.curve.wavelength_nm.back();
    if (warnings && (first > 400 || last < 700))
        warnings->push_back(std::string(name) + ": it covers " + to_text(first) + ".." + to_text(last) +
                            " nm only; its end values are held beyond");
    return {std::string(name), description_of(found), source_of(found, name), {std::move(found.curve)}};
}

} // namespace metamer
