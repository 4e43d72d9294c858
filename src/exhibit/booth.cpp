#include "exhibit/booth.h"

#include <algorithm>
#include <set>

#include "base/names.h"
#include "exhibit/scene_kinds.h"
#include "methods/metamers.h"

namespace metamer {

namespace {

constexpr double kGrays[] = {0.2, 0.3, 0.4};
// As in config/booth.ini: from above with shadows, and a softer one from the front that fills them.
constexpr double kKeyLight = 0.65, kFillLight = 0.45;

MaterialSetting added(Exhibit& exhibit, const Material& material) {
    const int key = add_material(exhibit.atlas, material);
    exhibit.materials.insert_or_assign(key, material);
    return {material, true, key};
}

LampSetting added(Exhibit& exhibit, const Lamp& lamp) {
    LampSetting setting;
    setting.lamp = lamp;
    setting.key = add_lamp(exhibit.atlas, lamp);
    return setting;
}

const Lamp& matching_lamp(const Exhibit& exhibit) {
    const bool is_own = exhibit.compare && exhibit.compare->left.lamp;
    return is_own ? exhibit.compare->left.lamp->lamp : exhibit.lamps.at(0).lamp;
}

Lamp parting_lamp(const Exhibit& exhibit) {
    if (exhibit.compare)
        return exhibit.compare->right.lamp ? exhibit.compare->right.lamp->lamp : exhibit.lamps.at(0).lamp;
    return find_lamp(same_name(matching_lamp(exhibit).name, "D65") ? "F11" : "D65");
}

/// The first materials of the exhibit's objects, each once.
std::vector<Material> samples(const Exhibit& exhibit) {
    std::vector<Material> out;
    std::set<int> keys;
    for (const ObjectSetting& object : exhibit.objects)
        if (out.size() < kMostSamples && keys.insert(object.material.key).second)
            out.push_back(object.material.material);
    return out;
}

} // namespace

CardMaterials card_materials(const Lamp& matching, const Lamp& parting) {
    const ReferenceLamp m = reference_lamp(matching.spectrum), p = reference_lamp(parting.spectrum);
    const Xyz white = reference_white(m);
    MetamericPair best = metameric_pair(m, p, kGrays[0] * white);
    for (const double gray : {kGrays[1], kGrays[2]})
        if (MetamericPair pair = metameric_pair(m, p, gray * white); pair.delta_e_2000 > best.delta_e_2000)
            best = std::move(pair);
    const std::string lamps = matching.name + ", " + parting.name;
    const auto card = [&](const char* letter, MaterialSpectrum spectrum) {
        return Material{"metamer " + std::string(letter) + " of " + lamps,
                        "one of two that match under " + matching.name + " and part under " + parting.name,
                        "computed: metamer mismatching (Logvinenko, Funt, Godau 2014)", std::move(spectrum)};
    };
    return {card("a", std::move(best.a)), card("b", std::move(best.b))};
}

void give_cards(Exhibit& exhibit) {
    const auto is_open = [](const ObjectSetting& object) { return object.material.key == 0; };
    if (std::ranges::none_of(exhibit.objects, is_open))
        return;
    const CardMaterials cards = card_materials(matching_lamp(exhibit), parting_lamp(exhibit));
    for (ObjectSetting& object : exhibit.objects)
        if (is_open(object))
            object.material = added(exhibit, object.name == "card-a" ? cards.a : cards.b);
}

Exhibit booth_exhibit(const Exhibit& base, const LampSetting& left, const LampSetting& right) {
    Exhibit booth;
    booth.place = base.place;
    booth.display = base.display;
    booth.accuracy = base.accuracy;
    booth.accuracy.method = std::nullopt;
    booth.scene = SceneKind::booth;
    booth.atlas = empty_atlas(base.atlas.quantization);
    const std::vector<Material> materials = samples(base);
    std::vector<std::string> names;
    for (const Material& material : materials) {
        added(booth, material);
        names.push_back(material.name);
    }
    for (const ObjectDefault& object : scene_objects(SceneKind::booth, names)) {
        ObjectSetting& setting = booth.objects.emplace_back();
        setting.name = object.name;
        const auto sample = std::ranges::find(materials, object.material, &Material::name);
        if (sample != materials.end())
            setting.material = added(booth, *sample);
        else if (!object.material.empty())
            setting.material = added(booth, find_material(object.material));
    }
    booth.lamps.assign(2, added(booth, left.lamp));
    booth.lamps[0].strength = kKeyLight;
    booth.lamps[0].shadow = true;
    booth.lamps[1].strength = kFillLight;
    booth.compare.emplace();
    booth.compare->line_px = base.compare ? base.compare->line_px : 0;
    booth.compare->left.lamp = booth.lamps[0];
    booth.compare->right.lamp = added(booth, right.lamp);
    give_cards(booth);
    return booth;
}

} // namespace metamer
