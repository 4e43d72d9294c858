#include "kiosk/hands.h"

#include <algorithm>
#include <cmath>

namespace metamer {

namespace {

constexpr double kSliderStep = 0.05, kSplitStep = 0.025;

/// By so many from the one that is open, round and round; where none is, the first or the last.
Action object_beside(int by, const Within& within) {
    const auto count = static_cast<int>(within.objects.size());
    const auto found =
        within.state->seen ? std::ranges::find(within.objects, *within.state->seen) : within.objects.end();
    const int at =
        found == within.objects.end() ? (by > 0 ? -1 : 0) : static_cast<int>(found - within.objects.begin());
    return within.objects[static_cast<std::size_t>((at + by + count) % count)];
}

std::optional<Action> action_of(const Widget& widget, const Within& within) {
    const auto index = static_cast<std::size_t>(widget.index);
    switch (widget.part) {
    case Part::lamp:
        return ChooseLamp{index, false};
    case Part::lamp_right:
        return ChooseLamp{index, true};
    case Part::mode:
        return ChooseMode{within.state->mode == Mode::methods ? Mode::booth : Mode::methods};
    case Part::language:
        return ChooseLanguage{within.words->languages()[index].code};
    case Part::expert:
        return ToggleExpert{};
    case Part::next:
        return within.objects.empty() ? std::nullopt : std::optional(object_beside(1, within));
    case Part::close:
        return ClosePanel{};
    default:
        return std::nullopt;
    }
}

double split_px(const Within& within) {
    const PxBox& scene = within.desk->layout.scene;
    return scene.left + within.state->split * scene.width;
}

bool can_split(const Within& within) {
    return within.desk->find(Part::split) != nullptr;
}

// The same widget after the desk was laid anew.
const Widget* same(const std::optional<Focus>& widget, const Within& within) {
    return widget ? within.desk->find(widget->part, widget->index) : nullptr;
}

} // namespace

Hands::Grab Hands::grabbed(const PointerEvent& event, const Within& within) const {
    Grab grab{std::nullopt, event.x_px, event.y_px};
    if (const Widget* widget = within.desk->at(event.x_px, event.y_px))
        grab.widget = Focus{widget->part, widget->index};
    const bool on_handle = grab.widget && grab.widget->part == Part::split;
    const bool on_line = !grab.widget && can_split(within) &&
                         within.desk->layout.scene.contains(event.x_px, event.y_px) &&
                         std::abs(event.x_px - split_px(within)) < kSplitReach * within.desk->layout.unit_px;
    grab.on_split = on_handle || on_line;
    grab.split_offset_px = grab.on_split ? split_px(within) - event.x_px : 0;
    return grab;
}

std::optional<Action> Hands::follow(const Grab& grab, const PointerEvent& event, const Within& within) const {
    const Layout& layout = within.desk->layout;
    if (grab.on_split && layout.scene.width > 0)
        return SetSplit{(event.x_px + grab.split_offset_px - layout.scene.left) / layout.scene.width};
    const Widget* widget = same(grab.widget, within);
    if (widget && widget->part == Part::strength)
        return SetStrength{
            strength_of_slider(slider_value(widget->box, layout.unit_px, widget->right_to_left, event.x_px))};
    return std::nullopt;
}

bool Hands::slipped(const Grab& grab, const PointerEvent& event, const Within& within) {
    const double most = grab.on_split ? kSplitSlip : kTapSlip;
    return std::hypot(event.x_px - grab.x_px, event.y_px - grab.y_px) > most * within.desk->layout.unit_px;
}

std::optional<Action> Hands::lift(const Grab& grab, const PointerEvent& event, const Within& within) const {
    if (grab.widget) {
        const Widget* widget = same(grab.widget, within);
        return widget && widget->box.contains(event.x_px, event.y_px) ? action_of(*widget, within)
                                                                      : std::nullopt;
    }
    if (grab.dragged)
        return std::nullopt;
    if (const auto seen = within.pick(event.x_px, event.y_px))
        return *seen;
    return within.state->seen ? std::optional<Action>(ClosePanel{}) : std::nullopt;
}

std::optional<Action> Hands::pointer(const PointerEvent& event, const Within& within) {
    focus_.reset();
    if (event.phase == PointerPhase::down) {
        const Grab grab = grabbed(event, within);
        fingers_.insert_or_assign(event.finger, grab);
        return grab.on_split ? std::nullopt : follow(grab, event, within);
    }
    const auto finger = fingers_.find(event.finger);
    if (finger == fingers_.end())
        return std::nullopt;
    finger->second.dragged = finger->second.dragged || slipped(finger->second, event, within);
    if (event.phase == PointerPhase::move)
        return follow(finger->second, event, within);
    const Grab grab = finger->second;
    fingers_.erase(finger);
    if (event.phase == PointerPhase::cancel)
        return std::nullopt;
    return lift(grab, event, within);
}

void Hands::move_focus(int by, const Within& within) {
    std::vector<Focus> order{kSceneFocus};
    for (const Widget& widget : within.desk->widgets)
        if (widget.touchable && widget.part != Part::panel)
            order.push_back({widget.part, widget.index});
    const auto count = static_cast<int>(order.size());
    const auto found = focus_ ? std::find(order.begin(), order.end(), *focus_) : order.end();
    const int at = found == order.end() ? (by > 0 ? -1 : 0) : static_cast<int>(found - order.begin());
    focus_ = order[static_cast<std::size_t>((at + by + count) % count)];
}

std::optional<Action> Hands::nudge(int by, const Within& within) {
    if (focus_ && focus_->part == Part::strength) {
        const Widget* slider = same(focus_, within);
        const int along = slider && slider->right_to_left ? -by : by;
        return SetStrength{
            strength_of_slider(slider_of_strength(within.state->strength) + along * kSliderStep)};
    }
    if (focus_ && focus_->part == Part::split)
        return SetSplit{within.state->split + by * kSplitStep};
    if (focus_ == kSceneFocus && !within.objects.empty())
        return object_beside(by, within);
    const bool mirrored = within.words->language(within.state->language).right_to_left;
    move_focus(mirrored ? -by : by, within);
    return std::nullopt;
}

std::optional<Action> Hands::enter(const Within& within) {
    if (!focus_ || focus_ == kSceneFocus)
        return within.objects.empty()
                   ? std::nullopt
                   : std::optional<Action>(within.state->seen ? *within.state->seen : within.objects.front());
    const Widget* widget = same(focus_, within);
    return widget ? action_of(*widget, within) : std::nullopt;
}

std::optional<Action> Hands::key(const KeyEvent& event, const Within& within) {
    switch (event.key) {
    case Key::tab:
    case Key::down:
        move_focus(1, within);
        return std::nullopt;
    case Key::back_tab:
    case Key::up:
        move_focus(-1, within);
        return std::nullopt;
    case Key::left:
        return nudge(-1, within);
    case Key::right:
        return nudge(1, within);
    case Key::enter:
        return enter(within);
    case Key::escape:
        break;
    }
    if (within.state->seen)
        return ClosePanel{};
    if (within.state->expert)
        return ToggleExpert{};
    focus_.reset();
    return std::nullopt;
}

void Hands::let_go() {
    fingers_.clear();
    focus_.reset();
}

} // namespace metamer
