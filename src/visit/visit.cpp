#include "visit/visit.h"

#include <algorithm>
#include <limits>

namespace metamer {

namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

bool is_night(const std::optional<NightHours>& night, int minute) {
    if (!night)
        return false;
    return night->from_min < night->to_min ? minute >= night->from_min && minute < night->to_min
                                           : minute >= night->from_min || minute < night->to_min;
}

/// Where a lamp of the old shelf stands on the new one: shelves are rearranged.
std::optional<std::size_t> same_lamp(const Exhibit& old, std::size_t index, const Exhibit& fresh) {
    if (index >= old.kiosk.lamps.size())
        return std::nullopt;
    const std::string& name = old.kiosk.lamps[index].lamp.name;
    for (std::size_t i = 0; i < fresh.kiosk.lamps.size(); ++i)
        if (fresh.kiosk.lamps[i].lamp.name == name)
            return i;
    return std::nullopt;
}

/// The fresh exhibit's start, and what a visitor chose in the old one; objects may be others.
VisitState kept(const Exhibit& old, const VisitState& state, const Exhibit& fresh) {
    const VisitState was = start_state(old);
    VisitState kept = start_state(fresh);
    if (state.lamp && state.lamp != was.lamp)
        if (const auto lamp = same_lamp(old, *state.lamp, fresh))
            kept.lamp = lamp;
    if (state.booth_left != was.booth_left)
        kept.booth_left = same_lamp(old, state.booth_left, fresh).value_or(kept.booth_left);
    if (state.booth_right != was.booth_right)
        kept.booth_right = same_lamp(old, state.booth_right, fresh).value_or(kept.booth_right);
    if (state.split != was.split)
        kept.split = state.split;
    if (state.language != was.language)
        kept.language = state.language;
    kept.strength = state.strength;
    kept.mode = lamps_to_choose(fresh) < 2 ? kept.mode : state.mode;
    kept.expert = state.expert;
    return kept;
}

/// One step of a visitor's wish, in a state of an exhibit.
struct Wish {
    const Exhibit& exhibit;
    VisitState& state;

    void operator()(const ChooseLamp& wish) const {
        if (wish.lamp >= exhibit.kiosk.lamps.size())
            return;
        if (state.mode == Mode::methods)
            state.lamp = wish.lamp;
        else
            (wish.right ? state.booth_right : state.booth_left) = wish.lamp;
    }
    void operator()(const SetStrength& wish) const {
        state.strength = std::clamp(wish.strength, kLeastStrength, kMostStrength);
    }
    void operator()(const SetSplit& wish) const { state.split = std::clamp(wish.split, 0.0, 1.0); }
    void operator()(const OpenObject& wish) const {
        if (wish.material.empty())
            return;
        state.seen = wish;
    }
    void operator()(const ClosePanel&) const { state.seen.reset(); }
    void operator()(const ChooseLanguage& wish) const { state.language = wish.language; }
    void operator()(const ToggleExpert&) const { state.expert = !state.expert; }
    void operator()(const ChooseMode& wish) const {
        if (wish.mode == Mode::booth && lamps_to_choose(exhibit) < 2)
            return;
        if (state.mode != wish.mode)
            state.seen.reset();
        state.mode = wish.mode;
    }
};

} // namespace

Visit::Visit(const Exhibit& exhibit, double now_s)
    : exhibit_(&exhibit), state_(start_state(exhibit)), touched_s_(now_s), now_s_(now_s) {}

bool Visit::touch(double now_s) {
    const bool woke = phase_ == Phase::night;
    if (phase_ != Phase::visitor)
        back_to_start();
    phase_ = Phase::visitor;
    touched_s_ = now_s_ = now_s;
    return woke;
}

void Visit::act(const Action& action) {
    if (phase_ == Phase::visitor)
        std::visit(Wish{*exhibit_, state_}, action);
}

void Visit::back_to_start() {
    state_ = start_state(*exhibit_);
    scene_.reset();
    step_ = -1;
}

void Visit::enter_step(std::size_t step, double now_s) {
    const TourStep& next = exhibit_->kiosk.tour[step];
    if (next.lamp)
        state_.lamp = next.lamp;
    if (next.split)
        state_.split = *next.split;
    if (next.scene)
        scene_ = next.scene;
    step_ = static_cast<int>(step);
    step_ends_s_ = now_s + next.seconds;
}

void Visit::tick(double now_s, int minute_of_day) {
    now_s_ = now_s;
    night_ = is_night(exhibit_->kiosk.night, minute_of_day);
    const bool idle = now_s - touched_s_ >= exhibit_->kiosk.idle_s;
    if (!idle)
        return;
    const bool toured = !exhibit_->kiosk.tour.empty();
    if (night_ && phase_ != Phase::night) {
        back_to_start();
        phase_ = Phase::night;
    } else if (!night_ && phase_ != Phase::tour) {
        back_to_start();
        phase_ = Phase::tour;
        if (toured)
            enter_step(0, now_s);
    } else if (phase_ == Phase::tour && toured && now_s >= step_ends_s_) {
        const std::size_t next = (static_cast<std::size_t>(step_) + 1) % exhibit_->kiosk.tour.size();
        if (next == 0) // a round begins as the first did
            back_to_start();
        enter_step(next, now_s);
    }
}

double Visit::next_s() const {
    double next = kNever;
    if (phase_ == Phase::visitor)
        next = touched_s_ + exhibit_->kiosk.idle_s;
    else if (phase_ == Phase::tour && step_ >= 0)
        next = step_ends_s_;
    return exhibit_->kiosk.night ? std::min(next, now_s_ + 60) : next;
}

std::string Visit::caption() const {
    return step_ >= 0 ? exhibit_->kiosk.tour[static_cast<std::size_t>(step_)].caption(state_.language) : "";
}

void Visit::take_over(const Exhibit& exhibit) {
    const Exhibit& old = *exhibit_;
    exhibit_ = &exhibit;
    if (phase_ == Phase::visitor) {
        state_ = kept(old, state_, exhibit);
        return;
    }
    // A tour begins anew at the next tick, the night goes on.
    back_to_start();
    if (phase_ == Phase::tour) {
        phase_ = Phase::visitor;
        touched_s_ = now_s_ - exhibit.kiosk.idle_s;
    }
}

} // namespace metamer
