// A visit: what touches and time make of the state. Pure: time is passed in, nothing is drawn here.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "visit/visit_state.h"

namespace metamer {

/// What a widget or a key asks for.
struct ChooseLamp {
    std::size_t lamp;
    bool right = false; ///< mode booth: for which side
};
struct SetStrength {
    double strength;
};
struct SetSplit {
    double split;
};
using OpenObject = Seen;
struct ClosePanel {};
struct ChooseLanguage {
    std::string language;
};
struct ToggleExpert {};
struct ChooseMode {
    Mode mode;
};
using Action = std::variant<ChooseLamp, SetStrength, SetSplit, OpenObject, ClosePanel, ChooseLanguage,
                            ToggleExpert, ChooseMode>;

/// Who has the exhibit.
enum class Phase {
    visitor, ///< somebody touched it less than idle_s ago
    tour,    ///< nobody did: [tour.N] runs, or, without one, the start state stands
    night,   ///< the screen is dark
};

/// All times in seconds of one steady clock.
class Visit {
public:
    /// The exhibit must outlive it. Starts with the tour's turn idle_s from now.
    Visit(const Exhibit& exhibit, double now_s);

    /// A touch, a click or a key, whatever it hits. Wakes the night for idle_s; ends the tour: the state
    /// returns to the start. Returns true where that is all it was for: a touch that wakes acts on nothing
    /// else.
    bool touch(double now_s);

    /// What the touch meant. Numbers are clamped to their ranges; a lamp that is not on the
    /// shelf, and a booth of less than two lamps, are ignored.
    void act(const Action& action);

    /// Moves on to this time. `minute_of_day`: local time, 0 .. 1439, for the night.
    void tick(double now_s, int minute_of_day);

    /// Another exhibit, or the same anew, takes the place of the old one: what a visitor chose stays as far
    /// as it is there; a tour begins again at the next tick.
    /// The old one must still be there.
    void take_over(const Exhibit& exhibit);

    /// State and scene are what they were in `good`: what was wished since, by a visitor or by the tour,
    /// could not be shown. Phase and step go on.
    void put_back(const Visit& good) {
        state_ = good.state_;
        scene_ = good.scene_;
    }

    /// When tick() has something to do next: the earliest of idle, the tour's next step, the next change of
    /// day and night (a minute from now at most, where there is a night).
    double next_s() const;

    const VisitState& state() const { return state_; }
    Phase phase() const { return phase_; }
    /// The tour's caption in the state's language; empty outside the tour.
    std::string caption() const;
    /// The exhibit that the tour shows instead; nullptr: the exhibit's own scene.
    const Exhibit* scene() const { return scene_.get(); }
    /// The tour's step, for whom it matters whether it is another; -1 outside the tour.
    int step() const { return step_; }

private:
    void back_to_start();
    void enter_step(std::size_t step, double now_s);

    const Exhibit* exhibit_;
    VisitState state_;
    Phase phase_ = Phase::visitor;
    double touched_s_, now_s_, step_ends_s_ = 0;
    int step_ = -1;
    bool night_ = false;
    std::shared_ptr<const Exhibit> scene_;
};

} // namespace metamer
