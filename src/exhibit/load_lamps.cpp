// [lamp.N]
#include <algorithm>
#include <cmath>

#include "exhibit/load_parts.h"
#include "exhibit/values.h"

namespace metamer {

namespace {

/// The sections of lamps by number, without gaps.
std::vector<Settings::Section> lamp_sections(const Settings& settings) {
    std::vector<Settings::Section> sections = settings.sections("lamp.N");
    std::ranges::sort(sections, {}, &Settings::Section::name);
    for (std::size_t i = 0; i < sections.size(); ++i)
        if (const std::string name = "lamp." + std::to_string(i + 1); sections[i].name != name)
            throw bad_input("read", sections[i].place,
                            "[" + sections[i].name + "] without [" + name +
                                "]; lamps are numbered from 1 without gaps");
    return sections;
}

Vec3 vector(const Setting& setting) {
    const std::vector<double> values = numbers(setting);
    return {values[0], values[1], values[2]};
}

Vec3 unit(const Setting& setting) {
    const Vec3 v = vector(setting);
    const double length = std::hypot(v[0], v[1], v[2]);
    if (length < 1e-6)
        throw refused(setting, "has no length: light must travel somewhere");
    return {v[0] / length, v[1] / length, v[2] / length};
}

Falloff falloff(const Setting& setting) {
    const Vec3 v = vector(setting);
    if (v[0] + v[1] + v[2] <= 0)
        throw refused(setting, "is all 0: the lamp would be infinitely bright");
    return {v[0], v[1], v[2]};
}

void place_lamp(const Settings& settings, const std::string& section, LampSetting& lamp) {
    const Setting* position = settings.find(section, "position");
    const Setting* direction = settings.find(section, "direction");
    if (position && direction)
        throw bad_input("read", direction->place,
                        "[" + section + "] has a direction and, at " + position->place +
                            ", a position; one of them");
    if (position)
        lamp.position = vector(*position);
    if (direction)
        lamp.direction = unit(*direction);
    if (const Setting* s = settings.find(section, "falloff")) {
        if (!position)
            throw refused(*s, "asks for a position: without one there is no distance");
        lamp.falloff = falloff(*s);
    }
}

LampSetting load_lamp(const Settings& settings, const std::string& section, Rows& rows,
                      const std::string& place) {
    const Setting* spectrum = settings.find(section, "spectrum");
    const Setting ours = unwritten(section, "spectrum", "D65", place);
    LampSetting lamp = rows.lamp(spectrum ? *spectrum : ours, spectrum ? spectrum->value : ours.value);
    if (const Setting* s = settings.find(section, "strength"))
        lamp.strength = number(*s);
    place_lamp(settings, section, lamp);
    if (const Setting* s = settings.find(section, "shadow"))
        lamp.shadow = yes_no(*s);
    return lamp;
}

/// Evenly lit scenes know no places: say so instead of doing nothing silently.
void warn_if_flat(const Settings& settings, const std::string& section, const SceneKindInfo& scene,
                  std::vector<std::string>* warnings) {
    if (!warnings || !scene.flat)
        return;
    for (const char* key : {"position", "direction", "falloff", "shadow"})
        if (const Setting* s = settings.find(section, key))
            warnings->push_back(s->place + ": " + key + " has no effect in scene " + std::string(scene.name) +
                                ", which is evenly lit");
}

} // namespace

std::vector<LampSetting> load_lamps(const Settings& settings, const SceneKindInfo& scene, Rows& rows,
                                    const std::string& place, std::vector<std::string>* warnings) {
    std::vector<LampSetting> lamps;
    int shadows = 0;
    for (const Settings::Section& section : lamp_sections(settings)) {
        lamps.push_back(load_lamp(settings, section.name, rows, place));
        warn_if_flat(settings, section.name, scene, warnings);
        if (const Setting* s = settings.find(section.name, "position"); s && scene.parallel)
            throw refused(*s, "is not for scene " + std::string(scene.name) +
                                  ", whose walls are lit evenly: give the lamp a direction");
        if (lamps.back().shadow && ++shadows > kMostShadows)
            throw bad_input("read", settings.find(section.name, "shadow")->place,
                            "shadow of a fifth lamp; at most " + std::to_string(kMostShadows) +
                                " may cast shadows");
    }
    if (lamps.empty())
        lamps.push_back(load_lamp(settings, "lamp.1", rows, place));
    return lamps;
}

} // namespace metamer
