#include "plan/half_view.h"

#include <algorithm>
#include <cmath>

#include "exhibit/scene_kinds.h"
#include "methods/three_numbers.h"

namespace metamer {

namespace {

std::vector<HalfLamp> lamps_of(const Exhibit& exhibit, const Half* half) {
    const bool lit = !scene_kind(exhibit.scene).flat;
    std::vector<HalfLamp> lamps;
    for (std::size_t i = 0; i < exhibit.lamps.size(); ++i) {
        const LampSetting& own = exhibit.lamps[i];
        const LampSetting& lamp = half && half->lamp ? *half->lamp : own;
        lamps.push_back({i, lamp.lamp.name, lamp.key, emission(exhibit.atlas, lamp.key), std::nullopt,
                         half && half->strength ? *half->strength : own.strength, own.shadow && lit});
        if (lamp.full_resolution)
            lamps.back().full = reference_lamp(lamp.lamp.spectrum);
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

HalfView view_for(const Exhibit& exhibit, const Half* half) {
    HalfView view;
    view.half = half;
    view.lamps = lamps_of(exhibit, half);
    view.dominant = static_cast<std::size_t>(
        std::max_element(view.lamps.begin(), view.lamps.end(),
                         [](const HalfLamp& a, const HalfLamp& b) { return a.strength < b.strength; }) -
        view.lamps.begin());
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

MethodChoice choice_of(const Exhibit& exhibit, const Half* half, const ObjectSetting& object) {
    if (object.method)
        return *object.method;
    return half && half->method ? *half->method : exhibit.accuracy.method;
}

std::vector<HalfView> half_views(const Exhibit& exhibit) {
    if (!exhibit.compare)
        return {view_for(exhibit, nullptr)};
    return {view_for(exhibit, &exhibit.compare->left), view_for(exhibit, &exhibit.compare->right)};
}

Pixel pixel_of(const HalfView& view) {
    Pixel pixel;
    for (const HalfLamp& lamp : view.lamps)
        pixel.lamps.push_back({&lamp.emission, lamp.full ? &*lamp.full : nullptr, lamp.strength, {}});
    return pixel;
}

} // namespace metamer
