#include "exhibit/load.h"

#include "base/error.h"
#include "base/files.h"
#include "base/names.h"
#include "base/numbers.h"
#include "exhibit/booth.h"
#include "exhibit/ini.h"
#include "exhibit/load_parts.h"
#include "spectra/spectrum_file.h"

namespace metamer_exhibit_files {
std::string_view embedded(std::string_view name);
}

namespace metamer {

namespace {

constexpr std::size_t kMostBytes = 1u << 20;
constexpr const char* kBuiltInPlace = "the built-in crayons.ini";

} // namespace

Setting unwritten(std::string_view section, std::string_view key, const std::string& value,
                  const std::string& place) {
    return {std::string(section), std::string(key), value, place, ".", find_key(section, key)};
}

namespace {

// The files that a value names, there or not.
void add_files(const Setting& setting, std::vector<std::filesystem::path>& files) {
    const auto add_spectrum = [&](const std::string& text) {
        if (const std::string path = path_named(trimmed(text)); !path.empty())
            files.push_back((setting.folder / path).lexically_normal()); // as it is read
    };
    switch (setting.info->kind) {
    case ValueKind::file:
        if (!setting.value.empty())
            files.push_back(setting.folder / setting.value);
        break;
    case ValueKind::lamp:
    case ValueKind::material:
        add_spectrum(setting.value);
        break;
    case ValueKind::lamps:
    case ValueKind::materials:
        for (const std::string& piece : split(setting.value, ','))
            add_spectrum(piece);
        break;
    default:
        break;
    }
}

Settings parse_settings(std::string_view text, const std::string& place, const std::filesystem::path& folder,
                        const std::vector<std::string>& sets) {
    Settings settings(parse_ini(text, place), place, folder);
    for (const std::string& set : sets)
        settings.set(set);
    return settings;
}

std::filesystem::path folder_of(const std::filesystem::path& path) {
    return path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
}

std::string_view built_in() {
    return metamer_exhibit_files::embedded("crayons.ini");
}

Exhibit build(const Settings& settings, const std::string& place, Use use,
              std::vector<std::string>* warnings) {
    Exhibit exhibit;
    exhibit.place = place;
    exhibit.display = load_display(settings);
    exhibit.accuracy = load_accuracy(settings);
    exhibit.scene = load_scene_kind(settings);
    const SceneKindInfo& scene = scene_kind(exhibit.scene);
    Rows rows = load_rows(settings, warnings);
    exhibit.lamps = load_lamps(settings, scene, rows, place, warnings);
    exhibit.compare = load_compare(settings, exhibit.display, rows);
    exhibit.kiosk = load_kiosk(settings, rows, use == Use::kiosk, place, [&](const Setting& materials) {
        Settings changed = settings.without("tour.N");
        Setting scene_materials = materials;
        scene_materials.section = "scene";
        changed.replace(std::move(scene_materials));
        return std::make_shared<const Exhibit>(build(changed, place, Use::kiosk, nullptr));
    });
    exhibit.objects = load_objects(settings, scene, rows, place, warnings); // after every lamp: see Rows
    exhibit.atlas = rows.atlas();
    exhibit.materials = rows.full_materials();
    give_cards(exhibit);
    return exhibit;
}

} // namespace

Exhibit parse_exhibit(std::string_view text, const std::string& place, const std::filesystem::path& folder,
                      const std::vector<std::string>& sets, std::vector<std::string>* warnings, Use use) {
    return build(parse_settings(text, place, folder, sets), place, use, warnings);
}

Exhibit load_exhibit(const std::filesystem::path& path, const std::vector<std::string>& sets,
                     std::vector<std::string>* warnings, Use use) {
    return parse_exhibit(read_file(path, kMostBytes), path.string(), folder_of(path), sets, warnings, use);
}

Exhibit default_exhibit(const std::vector<std::string>& sets, std::vector<std::string>* warnings, Use use) {
    return parse_exhibit(built_in(), kBuiltInPlace, ".", sets, warnings, use);
}

std::vector<std::filesystem::path> exhibit_files(const std::filesystem::path& path,
                                                 const std::vector<std::string>& sets) {
    std::vector<std::filesystem::path> files;
    if (!path.empty())
        files.push_back(path);
    try {
        const Settings settings =
            path.empty() ? parse_settings(built_in(), kBuiltInPlace, ".", sets)
                         : parse_settings(read_file(path, kMostBytes), path.string(), folder_of(path), sets);
        settings.each([&](const Setting& setting) { add_files(setting, files); });
    } catch (const Error&) {
        // Then it is the INI file itself that must change first.
    }
    return files;
}

} // namespace metamer
