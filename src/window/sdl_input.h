// SDL's events as the stage's own.
#pragma once

#include <SDL.h>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "window/events.h"
#include "window/rotation.h"

namespace metamer {

/// What is asked of SDL and told to it while events are read; for tests, something else.
struct SdlHost {
    std::function<int()> displays;                          ///< how many are connected
    std::function<bool(SDL_TouchID, SDL_FingerID)> touches; ///< whether that finger is still down
    std::function<void(bool)> show_cursor;
};

/// SDL itself.
SdlHost sdl_host();

/// Keeps what one event does not say: which fingers are down, whether anybody can see a frame, whether the
/// cursor is shown (hidden at first and after a touch, shown once a mouse moves).
class SdlInput {
public:
    SdlInput(int rotation_deg, SdlHost host);

    /// The framebuffer's size and the window's in SDL's coordinates, which differ where the desktop scales.
    void set_sizes(PxSize surface, PxSize window);
    /// For what is taken from now on.
    void set_rotation(int rotation_deg) { rotation_deg_ = rotation_deg; }

    /// Tells where nobody can see a frame any more, or can again, by what the host says of displays.
    void look_for_display(std::vector<Event>& events) { set_seen(window_shown_, events); }

    /// Whether anybody can see a frame, as was told last.
    bool seen() const { return seen_; }

    /// Appends what this event means; nothing for most. Sizes are the caller's to watch.
    void take(const SDL_Event& event, std::vector<Event>& events);

    /// Cancels the fingers that the host no longer knows: a touch screen that is unplugged, or whose cable
    /// shakes, never says `up`. To be called once all events are taken, for the host is already where the
    /// last of them leads.
    void cancel_lost(std::vector<Event>& events);

private:
    using Contact = std::pair<SDL_TouchID, SDL_FingerID>;

    void take_window(const SDL_WindowEvent& event, std::vector<Event>& events);
    void take_key(const SDL_KeyboardEvent& event, std::vector<Event>& events);
    void take_motion(const SDL_MouseMotionEvent& event, std::vector<Event>& events);
    void take_button(const SDL_MouseButtonEvent& event, std::vector<Event>& events);
    void take_finger(const SDL_TouchFingerEvent& event, std::vector<Event>& events);
    void down(Contact contact, PxPoint at, std::vector<Event>& events);
    void go_on(PointerPhase phase, Contact contact, PxPoint at, std::vector<Event>& events);
    void cancel_all(std::vector<Event>& events);
    void set_seen(bool window_shown, std::vector<Event>& events);
    void set_cursor(bool shown);
    PxPoint of_mouse(int x, int y) const;
    PxPoint of_finger(double x, double y) const;

    /// A finger of the stage, and where it was last.
    struct Finger {
        int number;
        PxPoint at;
    };
    int rotation_deg_;
    SdlHost host_;
    PxSize surface_{1, 1}, window_{1, 1};
    std::map<Contact, Finger> fingers_;
    bool window_shown_ = true, seen_ = true, cursor_ = false;
};

} // namespace metamer
