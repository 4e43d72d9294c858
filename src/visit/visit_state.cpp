#include "visit/visit_state.h"

#include <algorithm>
#include <cmath>

#include "exhibit/scene_kinds.h"

namespace metamer {

namespace {

// The shelf's lamp that all of the exhibit's lamps are already.
std::optional<std::size_t> lamp_in_use(const Exhibit& exhibit) {
    for (std::size_t i = 0; i < exhibit.kiosk.lamps.size(); ++i)
        if (std::ranges::all_of(exhibit.lamps, [&](const LampSetting& lamp) {
                return lamp.key == exhibit.kiosk.lamps[i].key;
            }))
            return i;
    return std::nullopt;
}

} // namespace

VisitState start_state(const Exhibit& exhibit) {
    VisitState state;
    state.lamp = lamp_in_use(exhibit);
    state.split = split_share(exhibit);
    state.language = exhibit.kiosk.language;
    state.booth_left = exhibit.kiosk.booth_left;
    state.booth_right = exhibit.kiosk.booth_right;
    return state;
}

double split_share(const Exhibit& exhibit) {
    if (!exhibit.compare)
        return 0;
    if (!exhibit.compare->split_px)
        return exhibit.compare->split;
    return std::min(static_cast<double>(*exhibit.compare->split_px) / exhibit.display.width_px, 1.0);
}

bool halves_side_by_side(const Exhibit& exhibit) {
    return exhibit.compare && scene_kind(exhibit.scene).each_half;
}

double slider_of_strength(double strength) {
    const double least = std::log(kLeastStrength), most = std::log(kMostStrength);
    return std::clamp((std::log(strength) - least) / (most - least), 0.0, 1.0);
}

double strength_of_slider(double slider) {
    return kLeastStrength * std::pow(kMostStrength / kLeastStrength, std::clamp(slider, 0.0, 1.0));
}

void apply(const VisitState& state, const Exhibit& exhibit, Exhibit& drawn) {
    for (std::size_t i = 0; i < exhibit.lamps.size(); ++i) {
        const LampSetting& source = state.lamp ? exhibit.kiosk.lamps[*state.lamp] : exhibit.lamps[i];
        LampSetting& lamp = drawn.lamps[i];
        lamp.lamp = source.lamp;
        lamp.full_resolution = source.full_resolution;
        lamp.key = source.key;
        lamp.strength = exhibit.lamps[i].strength * state.strength;
    }
    if (!exhibit.compare)
        return;
    for (Half Compare::*half : {&Compare::left, &Compare::right})
        if (const auto& own = ((*exhibit.compare).*half).strength)
            ((*drawn.compare).*half).strength = *own * state.strength;
}

std::size_t lamps_to_choose(const Exhibit& exhibit) {
    const bool own_lamps = exhibit.compare && exhibit.compare->left.lamp && exhibit.compare->right.lamp;
    return own_lamps ? 0 : exhibit.kiosk.lamps.size();
}

} // namespace metamer
