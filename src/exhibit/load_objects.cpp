// [scene] and [object.NAME]
#include <algorithm>
#include <map>

#include "base/names.h"
#include "exhibit/load_parts.h"
#include "exhibit/values.h"
#include "spectra/library.h"

namespace metamer {

namespace {

/// The materials of [scene] as they were written, each with what it was resolved to.
struct Palette {
    std::vector<std::string> texts;
    std::map<std::string, MaterialSetting> resolved;
};

/// The pieces of a list, a set's name in it replaced by the set.
std::vector<std::string> listed(const Setting& setting) {
    std::vector<std::string> texts;
    for (const std::string& item : split(setting.value, ',')) {
        if (item.empty())
            throw refused(setting, "has an empty name between its commas");
        const MaterialSet* set = find_material_set(item);
        if (set)
            texts.insert(texts.end(), set->materials.begin(), set->materials.end());
        else
            texts.push_back(item);
    }
    return texts;
}

void check_count(const Setting& setting, const SceneKindInfo& scene, std::size_t count) {
    const auto fewest = static_cast<std::size_t>(scene.fewest), most = static_cast<std::size_t>(scene.most);
    if (count >= fewest && count <= most)
        return;
    const std::string wanted = fewest == most ? "exactly " + std::to_string(fewest)
                                              : std::to_string(fewest) + " .. " + std::to_string(most);
    throw refused(setting, "is " + std::to_string(count) + " materials; scene " + std::string(scene.name) +
                               " takes " + wanted);
}

Palette load_palette(const Settings& settings, const SceneKindInfo& scene, Rows& rows,
                     const std::string& place) {
    const Setting* written = settings.find("scene", "materials");
    const Setting setting =
        written ? *written : unwritten("scene", "materials", std::string(scene.materials), place);
    const std::vector<std::string> own = rows.file_materials();
    const bool show_file = !written && !own.empty() && scene.most == kAtlasRows;
    Palette palette{show_file ? own : listed(setting), {}};
    check_count(setting, scene, palette.texts.size());
    for (const std::string& text : palette.texts)
        if (!palette.resolved.contains(text))
            palette.resolved.emplace(text, rows.material(setting, text));
    return palette;
}

/// Everything about one object that [object.NAME] says.
struct ObjectSection {
    const Settings& settings;
    std::string name;
    const Setting* find(std::string_view key) const { return settings.find(name, key); }
};

void load_bump(const ObjectSection& section, ObjectSetting& object) {
    const Setting* height = section.find("bump_height");
    if (const Setting* s = section.find("bump")) {
        object.bump_map = load_map(*s);
        object.bump = height ? number(*height) : 0.02;
    } else if (height) {
        throw refused(*height, "asks for a bump map: bump = FILE");
    }
}

void refuse_maps(const ObjectSection& section, const ObjectSetting& object, const SceneKindInfo& scene) {
    const bool ramp = object.material_end.has_value();
    const bool plain = scene.kind == SceneKind::media || scene.kind == SceneKind::corner;
    for (const char* key : {"key_map", "luminance_map", "bump"})
        if (const Setting* s = section.find(key); s && (ramp || plain))
            throw refused(*s, ramp ? "cannot be carried by a ramp"
                                   : "cannot be carried by the things of scene " + std::string(scene.name));
}

/// Only objects that are of glass or liquid by default have a medium: their shapes know a thickness.
void load_medium(const ObjectSection& section, Rows& rows, ObjectSetting& object) {
    for (const char* key : {"medium", "thickness"})
        if (const Setting* s = section.find(key); s && !object.medium)
            throw refused(*s, "is for the glass and the liquid of scene media");
    if (const Setting* s = section.find("medium"))
        object.medium = rows.material(*s, s->value);
    if (const Setting* s = section.find("thickness"))
        object.thickness = number(*s);
}

void change_object(const ObjectSection& section, const SceneKindInfo& scene, Rows& rows,
                   ObjectSetting& object) {
    refuse_maps(section, object, scene);
    if (const Setting* s = section.find("material"))
        object.material = rows.material(*s, s->value);
    if (const Setting* s = section.find("method"))
        object.method = method_choice(*s);
    load_medium(section, rows, object);
    if (const Setting* s = section.find("key_map"))
        object.key_map = load_map(*s);
    if (const Setting* s = section.find("luminance_map"))
        object.luminance_map = load_map(*s);
    load_bump(section, object);
    if (const Setting* s = section.find("specular"))
        object.specular = number(*s);
    if (const Setting* s = section.find("shininess"))
        object.shininess = number(*s);
}

/// Evenly lit scenes know no relief and no highlights: say so instead of doing nothing silently.
void warn_if_flat(const ObjectSection& section, const SceneKindInfo& scene,
                  std::vector<std::string>* warnings) {
    if (!warnings || !scene.flat)
        return;
    for (const char* key : {"bump", "bump_height", "specular", "shininess"})
        if (const Setting* s = section.find(key))
            warnings->push_back(s->place + ": " + key + " has no effect in scene " + std::string(scene.name) +
                                ", which is evenly lit");
}

/// Which objects [object.NAME] means: the one of that name, or all whose material in [scene] has it.
std::vector<std::size_t> meant(const std::string& name, const std::vector<ObjectDefault>& defaults) {
    std::vector<std::size_t> by_name, by_material;
    for (std::size_t i = 0; i < defaults.size(); ++i) {
        if (same_name(defaults[i].name, name))
            by_name.push_back(i);
        if (same_name(defaults[i].material, name) && defaults[i].material_end.empty())
            by_material.push_back(i);
    }
    return by_name.empty() ? by_material : by_name;
}

Error no_object(const Settings::Section& section, const std::string& name, const SceneKindInfo& scene,
                const std::vector<ObjectDefault>& defaults) {
    std::vector<std::string> names;
    for (const ObjectDefault& object : defaults)
        names.push_back(object.name);
    return bad_input("read", section.place,
                     "scene " + std::string(scene.name) + " has no object \"" + name + "\"" +
                         did_you_mean(name, names));
}

ObjectSetting by_default(const ObjectDefault& object, const Palette& palette, Rows& rows,
                         const Setting& blamed) {
    const auto resolve = [&](const std::string& text) {
        const auto found = palette.resolved.find(text);
        return found == palette.resolved.end() ? rows.material(blamed, text) : found->second;
    };
    ObjectSetting setting;
    setting.name = object.name;
    if (!object.material.empty())
        setting.material = resolve(object.material);
    if (!object.material_end.empty())
        setting.material_end = resolve(object.material_end);
    if (!object.medium.empty())
        setting.medium = resolve(object.medium);
    setting.thickness = object.thickness;
    setting.method = object.method;
    setting.specular = object.specular;
    setting.shininess = object.shininess;
    return setting;
}

} // namespace

SceneKind load_scene_kind(const Settings& settings) {
    const Setting* s = settings.find("scene", "kind");
    return s ? scene_kinds()[choice(*s)].kind : SceneKind::crayons;
}

std::vector<ObjectSetting> load_objects(const Settings& settings, const SceneKindInfo& scene, Rows& rows,
                                        const std::string& place, std::vector<std::string>* warnings) {
    const Palette palette = load_palette(settings, scene, rows, place);
    const std::vector<ObjectDefault> defaults = scene_objects(scene.kind, palette.texts);
    const Setting* kind = settings.find("scene", "kind");
    const Setting blamed = kind ? *kind : unwritten("scene", "kind", std::string(scene.name), place);
    std::vector<ObjectSetting> objects;
    for (const ObjectDefault& object : defaults)
        objects.push_back(by_default(object, palette, rows, blamed));

    std::map<std::size_t, std::string> changed_by;
    for (const Settings::Section& section : settings.sections("object.NAME")) {
        const std::string name = section.name.substr(std::string_view("object.").size());
        const std::vector<std::size_t> indices = meant(name, defaults);
        if (indices.empty())
            throw no_object(section, name, scene, defaults);
        warn_if_flat({settings, section.name}, scene, warnings);
        for (const std::size_t i : indices) {
            const auto [other, is_first] = changed_by.try_emplace(i, section.name);
            if (!is_first)
                throw bad_input("read", section.place,
                                "[" + section.name + "] and [" + other->second + "] mean the same object, " +
                                    objects[i].name);
            change_object({settings, section.name}, scene, rows, objects[i]);
        }
    }
    for (const auto& [i, section] : changed_by)
        if (objects[i].key_map)
            check_key_map(*settings.find(section, "key_map"), *objects[i].key_map, rows.atlas());
    return objects;
}

} // namespace metamer
