#include "exhibit/load.h"

#include "base/files.h"
#include "base/names.h"
#include "base/numbers.h"
#include "exhibit/booth.h"
#include "exhibit/ini.h"
#include "exhibit/load_parts.h"

namespace metamer_exhibit_files {
std::string_view embedded(std::string_view name);
}

namespace metamer {

namespace {

constexpr std::size_t kMostBytes = 1u << 20;

} // namespace

Setting unwritten(std::string_view section, std::string_view key, const std::string& value,
                  const std::string& place) {
    return {std::string(section), std::string(key), value, place, ".", find_key(section, key)};
}

namespace {

// What a value names that is a file: all of it, or pieces with commas between, `#column` aside.
void add_files(const Setting& setting, std::vector<std::filesystem::path>& files) {
    using enum ValueKind;
    const ValueKind kind = setting.info->kind;
    if (kind != file && kind != lamp && kind != lamps && kind != material && kind != materials)
        return;
    for (const std::string& piece : metamer::split(setting.value, ',')) {
        const std::string_view name = trimmed(std::string_view(piece).substr(0, piece.find('#')));
        std::error_code unreadable; // then it is no file of ours
        if (!name.empty() && std::filesystem::exists(setting.folder / name, unreadable))
            files.push_back(setting.folder / name);
    }
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
    settings.each([&](const Setting& setting) { add_files(setting, exhibit.files); });
    give_cards(exhibit);
    return exhibit;
}

} // namespace

Exhibit parse_exhibit(std::string_view text, const std::string& place, const std::filesystem::path& folder,
                      const std::vector<std::string>& sets, std::vector<std::string>* warnings, Use use) {
    Settings settings(parse_ini(text, place), place, folder);
    for (const std::string& set : sets)
        settings.set(set);
    return build(settings, place, use, warnings);
}

Exhibit load_exhibit(const std::filesystem::path& path, const std::vector<std::string>& sets,
                     std::vector<std::string>* warnings, Use use) {
    const std::filesystem::path folder =
        path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
    Exhibit exhibit = parse_exhibit(read_file(path, kMostBytes), path.string(), folder, sets, warnings, use);
    exhibit.files.insert(exhibit.files.begin(), path);
    return exhibit;
}

Exhibit default_exhibit(const std::vector<std::string>& sets, std::vector<std::string>* warnings, Use use) {
    return parse_exhibit(metamer_exhibit_files::embedded("crayons.ini"), "the built-in crayons.ini", ".",
                         sets, warnings, use);
}

} // namespace metamer
