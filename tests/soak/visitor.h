// A visitor who does anything that hands can do.
#pragma once

#include <deque>
#include <optional>
#include <random>

#include "kiosk/desk.h"
#include "window/events.h"
#include "window/rotation.h"

namespace metamer::test {

class Visitor {
public:
    explicit Visitor(std::uint32_t seed) : rng_(seed) {}

    /// What happens next: an event, or nothing for as long as the visitor only looks.
    std::optional<Event> next(const Desk& desk, PxSize picture);

    /// Forgets what was going on.
    void leave() { coming_.clear(); }

private:
    int up_to(int most) { return std::uniform_int_distribution<int>(0, most)(rng_); }
    double share() { return std::uniform_real_distribution<double>(0, 1)(rng_); }
    void tap(double x, double y, int finger = 0);
    void drag(double x, double y, double to_x, double to_y, int steps);
    void on_widget(const Desk& desk);
    void in_the_scene(const Desk& desk, PxSize picture);
    void by_keys();
    void with_all_fingers(PxSize picture);

    std::mt19937 rng_;
    std::deque<std::optional<Event>> coming_; ///< none: a frame's time of nothing
};

} // namespace metamer::test
