#include "report/chart_exhibits.h"

#include <algorithm>

namespace metamer {

namespace {

/// An object that may show every key of the exhibit's atlas.
ObjectSetting object_of_all(const Exhibit& exhibit) {
    ObjectSetting object;
    object.name = "pairs";
    const auto& [key, material] = *exhibit.materials.begin();
    object.material = {material, true, key};
    Image map{kAtlasSize, 1, std::vector<std::uint8_t>(4 * kAtlasSize, 255)};
    for (std::size_t x = 0; x < kAtlasSize; ++x)
        map.rgba[4 * x] = static_cast<std::uint8_t>(exhibit.materials.contains(static_cast<int>(x)) ? x : 0);
    object.key_map = map;
    return object;
}

} // namespace

Exhibit drawn_by(const Exhibit& exhibit, MethodChoice method, int taps) {
    Exhibit out = exhibit;
    out.compare.reset();
    out.accuracy.method = method;
    out.accuracy.taps = taps;
    for (ObjectSetting& object : out.objects)
        object.method.reset();
    return out;
}

Exhibit from_atlas_alone(const Exhibit& exhibit) {
    Exhibit out = exhibit;
    out.materials.clear();
    for (LampSetting& lamp : out.lamps)
        lamp.full_resolution = false;
    return out;
}

std::vector<Exhibit> pair_exhibits(std::span<const Lamp> lamps, std::span<const Material> materials,
                                   const Display& display) {
    std::vector<Exhibit> out;
    for (std::size_t begin = 0; begin < materials.size(); begin += kAtlasRows) {
        Exhibit shared;
        shared.place = "pairs";
        shared.display = display;
        shared.scene = SceneKind::still_life;
        shared.atlas = empty_atlas();
        for (std::size_t m = begin; m < std::min(materials.size(), begin + kAtlasRows); ++m)
            shared.materials.emplace(add_material(shared.atlas, materials[m]), materials[m]);
        shared.objects = {object_of_all(shared)};
        for (const Lamp& lamp : lamps) {
            Exhibit& exhibit = out.emplace_back(shared);
            LampSetting& setting = exhibit.lamps.emplace_back();
            setting.lamp = lamp;
            setting.key = add_lamp(exhibit.atlas, lamp);
        }
    }
    return out;
}

} // namespace metamer
