#include "render/half_view.h"

#include <algorithm>
#include <cmath>

#include "methods/three_numbers.h"

namespace metamer {

namespace {

glm::vec4 place_of(const LampSetting& lamp, const glm::vec3& scene_direction) {
    if (lamp.position)
        return {(*lamp.position)[0], (*lamp.position)[1], (*lamp.position)[2], 1};
    if (lamp.direction) // light travels along it, shaders look back towards the lamp
        return {-(*lamp.direction)[0], -(*lamp.direction)[1], -(*lamp.direction)[2], 0};
    return {scene_direction, 0};
}

std::vector<HalfLamp> lamps_of(const Exhibit& exhibit, const Half* half, const Scene& scene) {
    std::vector<HalfLamp> lamps;
    for (std::size_t i = 0; i < exhibit.lamps.size(); ++i) {
        const LampSetting& lamp = exhibit.lamps[i];
        const int key = half && half->lamp ? half->lamp->key : lamp.key;
        const double strength = half && half->strength ? *half->strength : lamp.strength;
        lamps.push_back({key, emission(exhibit.atlas, key), strength,
                         place_of(lamp, scene.lamp_directions.at(i)), lamp.falloff,
                         lamp.shadow && scene.lit});
    }
    std::stable_sort(lamps.begin(), lamps.end(),
                     [](const auto& a, const auto& b) { return a.shadow > b.shadow; });
    return lamps;
}

// The white of all lamps together, as an eye adapts to what it stands in.
Matrix3 adaptation_to(const std::vector<HalfLamp>& lamps, const GridObserver& observer,
                      const Matrix3& rgb_from_xyz) {
    Xyz light;
    for (const HalfLamp& lamp : lamps)
        light = light + lamp.strength * lamp_xyz(lamp.emission, observer);
    const auto xyz_from_rgb = inverse(rgb_from_xyz);
    if (!(light.y > 0) || !xyz_from_rgb)
        return Matrix3::identity();
    return bradford((1 / light.y) * light, to_xyz(*xyz_from_rgb, {1, 1, 1}));
}

HalfView view_for(const Exhibit& exhibit, const Half* half, const Scene& scene) {
    HalfView view;
    view.half = half;
    view.lamps = lamps_of(exhibit, half, scene);
    view.shadows = static_cast<int>(std::count_if(view.lamps.begin(), view.lamps.end(),
                                                  [](const HalfLamp& lamp) { return lamp.shadow; }));
    const Display& display = exhibit.display;
    const bool own_matrix = display.matrix && !(half && half->working_space);
    const WorkingSpace& space = half && half->working_space ? *half->working_space : *display.working_space;
    view.output.rgb_from_xyz = own_matrix ? *display.matrix : rgb_from_xyz(space);
    view.output.white = &white_emission(own_matrix ? working_spaces()[0] : space);
    view.output.transfer = display.transfer;
    if (display.adaptation == Adaptation::bradford)
        view.output.adaptation = adaptation_to(view.lamps, observer(exhibit.atlas), view.output.rgb_from_xyz);
    return view;
}

} // namespace

int split_column(const Compare& compare, int width_px) {
    const int column =
        compare.split_px ? *compare.split_px : static_cast<int>(std::lround(compare.split * width_px));
    return std::clamp(column, 0, width_px);
}

Method method_of(const Exhibit& exhibit, const Half* half, const ObjectSetting& object) {
    if (object.method)
        return *object.method;
    return half && half->method ? *half->method : exhibit.method;
}

std::vector<HalfView> half_views(const Exhibit& exhibit, const Scene& scene) {
    if (!exhibit.compare)
        return {view_for(exhibit, nullptr, scene)};
    return {view_for(exhibit, &exhibit.compare->left, scene),
            view_for(exhibit, &exhibit.compare->right, scene)};
}

} // namespace metamer
