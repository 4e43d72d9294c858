#include "window/sdl_input.h"

#include <algorithm>
#include <optional>

namespace metamer {

namespace {

const std::pair<SDL_TouchID, SDL_FingerID> kMouse{SDL_MOUSE_TOUCHID, 0};

bool finger_is_down(SDL_TouchID device, SDL_FingerID finger) {
    for (int i = 0; i < SDL_GetNumTouchFingers(device); ++i)
        if (const SDL_Finger* down = SDL_GetTouchFinger(device, i); down != nullptr && down->id == finger)
            return true;
    return false;
}

std::optional<Key> key_of(const SDL_Keysym& pressed) {
    switch (pressed.sym) {
    case SDLK_LEFT:
    case SDLK_KP_4:
        return Key::left;
    case SDLK_RIGHT:
    case SDLK_KP_6:
        return Key::right;
    case SDLK_UP:
    case SDLK_KP_8:
        return Key::up;
    case SDLK_DOWN:
    case SDLK_KP_2:
        return Key::down;
    case SDLK_RETURN:
    case SDLK_RETURN2:
    case SDLK_KP_ENTER:
    case SDLK_KP_5: // the middle of a keypad's arrows
    case SDLK_SPACE:
        return Key::enter;
    case SDLK_ESCAPE:
    case SDLK_AC_BACK:
        return Key::escape;
    case SDLK_TAB:
        return (pressed.mod & KMOD_SHIFT) != 0 ? Key::back_tab : Key::tab;
    default:
        return std::nullopt;
    }
}

} // namespace

SdlHost sdl_host() {
    return {SDL_GetNumVideoDisplays, finger_is_down,
            [](bool shown) { SDL_ShowCursor(shown ? SDL_ENABLE : SDL_DISABLE); }};
}

SdlInput::SdlInput(int rotation_deg, SdlHost host) : rotation_deg_(rotation_deg), host_(std::move(host)) {
    host_.show_cursor(false);
}

void SdlInput::set_sizes(PxSize surface, PxSize window) {
    surface_ = surface;
    window_ = {std::max(window.width_px, 1), std::max(window.height_px, 1)};
}

void SdlInput::take(const SDL_Event& event, std::vector<Event>& events) {
    switch (event.type) {
    case SDL_QUIT:
        events.emplace_back(QuitEvent{});
        break;
    case SDL_WINDOWEVENT:
        take_window(event.window, events);
        break;
    case SDL_DISPLAYEVENT:
        look_for_display(events);
        break;
    case SDL_KEYDOWN:
        take_key(event.key, events);
        break;
    case SDL_MOUSEMOTION:
        take_motion(event.motion, events);
        break;
    case SDL_MOUSEBUTTONDOWN:
    case SDL_MOUSEBUTTONUP:
        take_button(event.button, events);
        break;
    case SDL_FINGERDOWN:
    case SDL_FINGERMOTION:
    case SDL_FINGERUP:
        take_finger(event.tfinger, events);
        break;
    default:
        break;
    }
}

void SdlInput::take_window(const SDL_WindowEvent& event, std::vector<Event>& events) {
    switch (event.event) {
    case SDL_WINDOWEVENT_CLOSE:
        events.emplace_back(QuitEvent{});
        break;
    case SDL_WINDOWEVENT_EXPOSED:
        events.emplace_back(ExposeEvent{});
        break;
    case SDL_WINDOWEVENT_HIDDEN:
    case SDL_WINDOWEVENT_MINIMIZED:
        set_seen(false, events);
        break;
    case SDL_WINDOWEVENT_SHOWN:
    case SDL_WINDOWEVENT_RESTORED:
    case SDL_WINDOWEVENT_MAXIMIZED:
        set_seen(true, events);
        break;
    default:
        break;
    }
}

void SdlInput::set_seen(bool window_shown, std::vector<Event>& events) {
    window_shown_ = window_shown;
    const bool seen = window_shown && host_.displays() > 0;
    if (seen == seen_)
        return;
    seen_ = seen;
    if (seen) {
        events.emplace_back(DisplayBackEvent{});
    } else {
        cancel_all(events);
        events.emplace_back(DisplayGoneEvent{});
    }
}

void SdlInput::take_key(const SDL_KeyboardEvent& event, std::vector<Event>& events) {
    const std::optional<Key> key = key_of(event.keysym);
    // A key that is held goes on moving, but chooses once.
    if (key && (event.repeat == 0 || (*key != Key::enter && *key != Key::escape)))
        events.emplace_back(KeyEvent{*key});
}

void SdlInput::take_motion(const SDL_MouseMotionEvent& event, std::vector<Event>& events) {
    // A window that opens under a resting mouse moves by nothing.
    if (event.which == SDL_TOUCH_MOUSEID || (event.xrel == 0 && event.yrel == 0))
        return;
    set_cursor(true);
    go_on(PointerPhase::move, kMouse, of_mouse(event.x, event.y), events);
}

void SdlInput::take_button(const SDL_MouseButtonEvent& event, std::vector<Event>& events) {
    if (event.which == SDL_TOUCH_MOUSEID || event.button != SDL_BUTTON_LEFT)
        return;
    if (event.type == SDL_MOUSEBUTTONDOWN)
        down(kMouse, of_mouse(event.x, event.y), events);
    else
        go_on(PointerPhase::up, kMouse, of_mouse(event.x, event.y), events);
}

void SdlInput::take_finger(const SDL_TouchFingerEvent& event, std::vector<Event>& events) {
    if (event.touchId == SDL_MOUSE_TOUCHID)
        return;
    const Contact contact{event.touchId, event.fingerId};
    const PxPoint at = of_finger(static_cast<double>(event.x), static_cast<double>(event.y));
    if (event.type == SDL_FINGERDOWN) {
        set_cursor(false);
        down(contact, at, events);
    } else {
        go_on(event.type == SDL_FINGERUP ? PointerPhase::up : PointerPhase::move, contact, at, events);
    }
}

void SdlInput::down(Contact contact, PxPoint at, std::vector<Event>& events) {
    go_on(PointerPhase::cancel, contact, at, events); // its up was lost
    int number = 0;
    const auto taken = [&](const auto& finger) { return finger.second.number == number; };
    while (std::any_of(fingers_.begin(), fingers_.end(), taken))
        ++number;
    fingers_.emplace(contact, Finger{number, at});
    go_on(PointerPhase::down, contact, at, events);
}

/// Nothing where that contact did not begin here.
void SdlInput::go_on(PointerPhase phase, Contact contact, PxPoint at, std::vector<Event>& events) {
    const auto finger = fingers_.find(contact);
    if (finger == fingers_.end())
        return;
    finger->second.at = at;
    events.emplace_back(PointerEvent{phase, finger->second.number, at.x_px, at.y_px});
    if (phase == PointerPhase::up || phase == PointerPhase::cancel)
        fingers_.erase(finger);
}

void SdlInput::cancel_lost(std::vector<Event>& events) {
    for (auto next = fingers_.begin(); next != fingers_.end();) {
        const auto [contact, finger] = *next++; // it may go
        if (contact != kMouse && !host_.touches(contact.first, contact.second))
            go_on(PointerPhase::cancel, contact, finger.at, events);
    }
}

void SdlInput::cancel_all(std::vector<Event>& events) {
    while (!fingers_.empty())
        go_on(PointerPhase::cancel, fingers_.begin()->first, fingers_.begin()->second.at, events);
}

void SdlInput::set_cursor(bool shown) {
    if (shown != cursor_)
        host_.show_cursor(shown);
    cursor_ = shown;
}

PxPoint SdlInput::of_mouse(int x, int y) const {
    return picture_from_surface({(x + 0.5) * surface_.width_px / window_.width_px,
                                 (y + 0.5) * surface_.height_px / window_.height_px},
                                surface_, rotation_deg_);
}

/// SDL's 0 .. 1 are the first and the last pixel.
PxPoint SdlInput::of_finger(double x, double y) const {
    return picture_from_surface({std::clamp(x, 0.0, 1.0) * (surface_.width_px - 1) + 0.5,
                                 std::clamp(y, 0.0, 1.0) * (surface_.height_px - 1) + 0.5},
                                surface_, rotation_deg_);
}

} // namespace metamer
