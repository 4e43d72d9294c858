#include "kiosk/description.h"

#include <nlohmann/json.hpp>

namespace metamer {

namespace {

using Json = nlohmann::ordered_json;

Json box(const PxBox& box, Shift shift) {
    return {box.left + shift.x_px, box.top + shift.y_px, box.width, box.height};
}

const char* phase_name(Phase phase) {
    switch (phase) {
    case Phase::visitor:
        return "visitor";
    case Phase::tour:
        return "tour";
    case Phase::night:
        break;
    }
    return "night";
}

Json widget_json(const Widget& widget, Shift shift) {
    Json out{{"part", part_name(widget.part)},
             {"index", widget.index},
             {"box", box(widget.box, shift)},
             {"text", widget.text},
             {"on", widget.on},
             {"focused", widget.focused},
             {"value", widget.value}};
    if (widget.product)
        out["colors"] = {widget.product->left, widget.product->right};
    if (widget.expert)
        out["rows"] = widget.expert->rows;
    return out;
}

} // namespace

const char* part_name(Part part) {
    switch (part) {
    case Part::left_label:
        return "left-label";
    case Part::right_label:
        return "right-label";
    case Part::split:
        return "split";
    case Part::lamp:
        return "lamp";
    case Part::lamp_right:
        return "lamp-right";
    case Part::strength:
        return "strength";
    case Part::mode:
        return "mode";
    case Part::language:
        return "language";
    case Part::expert:
        return "expert";
    case Part::panel:
        return "panel";
    case Part::next:
        return "next";
    case Part::close:
        return "close";
    case Part::expert_panel:
        return "expert-panel";
    case Part::caption:
        return "caption";
    case Part::hint:
        return "hint";
    case Part::notice:
        break;
    }
    return "notice";
}

std::string description(const Desk& desk, const Visit& visit, PxSize picture, Shift shift) {
    const VisitState& state = visit.state();
    Json out{{"width_px", picture.width_px},
             {"height_px", picture.height_px},
             {"phase", phase_name(visit.phase())},
             {"mode", state.mode == Mode::booth ? "booth" : "methods"},
             {"language", state.language},
             {"split", state.split},
             {"strength", state.strength},
             {"scene", box(desk.layout.scene, shift)},
             {"widgets", Json::array()}};
    for (const Widget& widget : desk.widgets)
        out["widgets"].push_back(widget_json(widget, shift));
    // An error may hold any byte of the file that it is about.
    return out.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace metamer
