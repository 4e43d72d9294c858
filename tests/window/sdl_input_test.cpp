#include "window/sdl_input.h"

#include <gmock/gmock.h>
#include <set>

#include "window/event_text.h"

namespace metamer {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using Texts = std::vector<std::string>;

SDL_Event finger(Uint32 type, SDL_FingerID id, float x, float y, SDL_TouchID device = 7) {
    SDL_Event event{};
    event.type = type;
    event.tfinger.touchId = device;
    event.tfinger.fingerId = id;
    event.tfinger.x = x;
    event.tfinger.y = y;
    return event;
}

SDL_Event button(Uint32 type, int x, int y, Uint8 which = SDL_BUTTON_LEFT, Uint32 device = 0) {
    SDL_Event event{};
    event.type = type;
    event.button.which = device;
    event.button.button = which;
    event.button.x = x;
    event.button.y = y;
    return event;
}

SDL_Event motion(int x, int y, int by = 1, Uint32 device = 0) {
    SDL_Event event{};
    event.type = SDL_MOUSEMOTION;
    event.motion.which = device;
    event.motion.x = x;
    event.motion.y = y;
    event.motion.xrel = by;
    return event;
}

SDL_Event key(SDL_Keycode code, Uint16 modifiers = KMOD_NONE, Uint8 repeat = 0) {
    SDL_Event event{};
    event.type = SDL_KEYDOWN;
    event.key.keysym.sym = code;
    event.key.keysym.mod = modifiers;
    event.key.repeat = repeat;
    return event;
}

SDL_Event window(SDL_WindowEventID id) {
    SDL_Event event{};
    event.type = SDL_WINDOWEVENT;
    event.window.event = static_cast<Uint8>(id);
    return event;
}

SDL_Event display() {
    SDL_Event event{};
    event.type = SDL_DISPLAYEVENT;
    return event;
}

/// An input over a surface of 801 x 401 px, with a host that the test plays.
class SdlInputTest : public testing::Test {
protected:
    SdlInput input(int rotation_deg = 0, PxSize window_size = {801, 401}) {
        const SdlHost host{[this] { return displays_; },
                           [this](SDL_TouchID, SDL_FingerID id) { return !up_.contains(id); },
                           [this](bool shown) { cursor_ = shown; }};
        SdlInput made(rotation_deg, host);
        made.set_sizes({801, 401}, window_size);
        return made;
    }
    static Texts take(SdlInput& input, std::initializer_list<SDL_Event> events) {
        std::vector<Event> taken;
        for (const SDL_Event& event : events)
            input.take(event, taken);
        return test::texts(taken);
    }

    static Texts lost(SdlInput& input) {
        std::vector<Event> told;
        input.cancel_lost(told);
        return test::texts(told);
    }

    int displays_ = 1;
    std::set<SDL_FingerID> up_; ///< what the host no longer knows
    bool cursor_ = true;
};

TEST_F(SdlInputTest, AFingerDrags) {
    SdlInput in = input();
    EXPECT_THAT(take(in, {finger(SDL_FINGERDOWN, 41, 0, 0), finger(SDL_FINGERMOTION, 41, 0.5F, 0.25F),
                          finger(SDL_FINGERUP, 41, 1, 1)}),
                ElementsAre("down 0 0.5 0.5", "move 0 400.5 100.5", "up 0 800.5 400.5"));
}

TEST_F(SdlInputTest, FingersAreNumberedFromTheLeastThatIsFree) {
    SdlInput in = input();
    EXPECT_THAT(take(in, {finger(SDL_FINGERDOWN, 90, 0, 0), finger(SDL_FINGERDOWN, 91, 1, 1),
                          finger(SDL_FINGERUP, 90, 0, 0), finger(SDL_FINGERDOWN, 92, 0, 1),
                          finger(SDL_FINGERUP, 91, 1, 1), finger(SDL_FINGERUP, 92, 0, 1)}),
                ElementsAre("down 0 0.5 0.5", "down 1 800.5 400.5", "up 0 0.5 0.5", "down 0 0.5 400.5",
                            "up 1 800.5 400.5", "up 0 0.5 400.5"));
}

TEST_F(SdlInputTest, FingersOfTwoScreensAreTwo) {
    SdlInput in = input();
    EXPECT_THAT(take(in, {finger(SDL_FINGERDOWN, 1, 0, 0, 7), finger(SDL_FINGERDOWN, 1, 1, 1, 8),
                          finger(SDL_FINGERUP, 1, 0, 0, 7)}),
                ElementsAre("down 0 0.5 0.5", "down 1 800.5 400.5", "up 0 0.5 0.5"));
}

TEST_F(SdlInputTest, AFingerThatDidNotComeDownHereIsNone) {
    SdlInput in = input();
    EXPECT_THAT(take(in, {finger(SDL_FINGERMOTION, 5, 0, 0), finger(SDL_FINGERUP, 5, 0, 0)}), IsEmpty());
}

TEST_F(SdlInputTest, AFingerStaysOnTheSurface) {
    SdlInput in = input();
    EXPECT_THAT(take(in, {finger(SDL_FINGERDOWN, 5, -0.1F, 1.5F)}), ElementsAre("down 0 0.5 400.5"));
}

/// The touch screen was unplugged with a finger on it: the next touch is the first finger again.
TEST_F(SdlInputTest, AFingerWithoutAnEndIsCanceled) {
    SdlInput in = input();
    take(in, {finger(SDL_FINGERDOWN, 1, 0, 0), button(SDL_MOUSEBUTTONDOWN, 1, 1)});
    EXPECT_THAT(lost(in), IsEmpty());
    up_ = {1};
    EXPECT_THAT(lost(in), ElementsAre("cancel 0 0.5 0.5")) << "the mouse is no finger of SDL's";
    EXPECT_THAT(lost(in), IsEmpty());
    EXPECT_THAT(take(in, {finger(SDL_FINGERDOWN, 2, 1, 1, 8)}), ElementsAre("down 0 800.5 400.5"));
}

/// SDL knows the end of what it has read at once before the first event of it is taken.
TEST_F(SdlInputTest, AFingerWhoseEndIsYetToBeTakenIsNotLost) {
    SdlInput in = input();
    take(in, {finger(SDL_FINGERDOWN, 1, 0, 0)});
    up_ = {1};
    EXPECT_THAT(take(in, {finger(SDL_FINGERDOWN, 2, 1, 1), finger(SDL_FINGERUP, 1, 0, 0)}),
                ElementsAre("down 1 800.5 400.5", "up 0 0.5 0.5"));
    EXPECT_THAT(lost(in), IsEmpty());
}

TEST_F(SdlInputTest, AFingerThatComesDownTwiceIsCanceledBetween) {
    SdlInput in = input();
    EXPECT_THAT(take(in, {finger(SDL_FINGERDOWN, 1, 0, 0), finger(SDL_FINGERDOWN, 1, 1, 1)}),
                ElementsAre("down 0 0.5 0.5", "cancel 0 800.5 400.5", "down 0 800.5 400.5"));
}

TEST_F(SdlInputTest, TheMouseIsAFingerWhileItsLeftButtonIsDown) {
    SdlInput in = input();
    EXPECT_THAT(take(in, {motion(10, 20), button(SDL_MOUSEBUTTONDOWN, 10, 20), motion(11, 20),
                          button(SDL_MOUSEBUTTONUP, 12, 20), motion(13, 20)}),
                ElementsAre("down 0 10.5 20.5", "move 0 11.5 20.5", "up 0 12.5 20.5"));
    EXPECT_THAT(take(in, {button(SDL_MOUSEBUTTONDOWN, 10, 20, SDL_BUTTON_RIGHT),
                          button(SDL_MOUSEBUTTONUP, 10, 20, SDL_BUTTON_RIGHT)}),
                IsEmpty());
}

TEST_F(SdlInputTest, WhatSdlMakesOfAnotherDeviceIsToldOnce) {
    SdlInput in = input();
    EXPECT_THAT(
        take(in, {button(SDL_MOUSEBUTTONDOWN, 1, 1, SDL_BUTTON_LEFT, SDL_TOUCH_MOUSEID),
                  motion(2, 2, 1, SDL_TOUCH_MOUSEID), finger(SDL_FINGERDOWN, 0, 0, 0, SDL_MOUSE_TOUCHID)}),
        IsEmpty());
    EXPECT_FALSE(cursor_);
}

TEST_F(SdlInputTest, TheMouseIsScaledWhereTheDesktopScales) {
    SdlInput in = input(0, {267, 100});
    EXPECT_THAT(take(in, {button(SDL_MOUSEBUTTONDOWN, 100, 50)}), ElementsAre("down 0 301.5 202.505"));
}

TEST_F(SdlInputTest, PointersAreTurnedWithThePicture) {
    const std::pair<int, const char*> turns[] = {{0, "down 0 10.5 20.5"},
                                                 {90, "down 0 20.5 790.5"},
                                                 {180, "down 0 790.5 380.5"},
                                                 {270, "down 0 380.5 10.5"}};
    for (const auto& [rotation_deg, wanted] : turns) {
        SdlInput in = input(rotation_deg);
        EXPECT_THAT(take(in, {button(SDL_MOUSEBUTTONDOWN, 10, 20)}), ElementsAre(wanted)) << rotation_deg;
        EXPECT_THAT(take(in, {button(SDL_MOUSEBUTTONUP, 10, 20),
                              finger(SDL_FINGERDOWN, 1, 10 / 800.0F, 20 / 400.0F)})[1]
                        .substr(0, 11),
                    std::string(wanted).substr(0, 11))
            << rotation_deg;
    }
}

TEST_F(SdlInputTest, KeysByWhatTheyMean) {
    SdlInput in = input();
    EXPECT_THAT(take(in, {key(SDLK_LEFT), key(SDLK_RIGHT), key(SDLK_UP), key(SDLK_DOWN)}),
                ElementsAre("key left", "key right", "key up", "key down"));
    EXPECT_THAT(take(in, {key(SDLK_KP_4), key(SDLK_KP_6), key(SDLK_KP_8), key(SDLK_KP_2)}),
                ElementsAre("key left", "key right", "key up", "key down"));
    EXPECT_THAT(take(in, {key(SDLK_RETURN), key(SDLK_KP_ENTER), key(SDLK_SPACE), key(SDLK_KP_5)}),
                ElementsAre("key enter", "key enter", "key enter", "key enter"));
    EXPECT_THAT(take(in, {key(SDLK_ESCAPE), key(SDLK_AC_BACK)}), ElementsAre("key escape", "key escape"));
    EXPECT_THAT(take(in, {key(SDLK_TAB), key(SDLK_TAB, KMOD_LSHIFT), key(SDLK_TAB, KMOD_RSHIFT)}),
                ElementsAre("key tab", "key back_tab", "key back_tab"));
    EXPECT_THAT(take(in, {key(SDLK_a), key(SDLK_KP_1), key(SDLK_LSHIFT)}), IsEmpty());
}

TEST_F(SdlInputTest, AKeyThatIsHeldMovesOnButChoosesOnce) {
    SdlInput in = input();
    EXPECT_THAT(
        take(in, {key(SDLK_LEFT, 0, 1), key(SDLK_TAB, 0, 1), key(SDLK_RETURN, 0, 1), key(SDLK_ESCAPE, 0, 1)}),
        ElementsAre("key left", "key tab"));
}

TEST_F(SdlInputTest, TheWindowsEvents) {
    SdlInput in = input();
    EXPECT_THAT(take(in, {window(SDL_WINDOWEVENT_EXPOSED), window(SDL_WINDOWEVENT_CLOSE),
                          window(SDL_WINDOWEVENT_FOCUS_LOST)}),
                ElementsAre("expose", "quit"));
    SDL_Event quit{};
    quit.type = SDL_QUIT;
    EXPECT_THAT(take(in, {quit}), ElementsAre("quit"));
}

TEST_F(SdlInputTest, TheDisplayIsGoneOnceAndBackOnce) {
    SdlInput in = input();
    EXPECT_THAT(take(in, {window(SDL_WINDOWEVENT_SHOWN), window(SDL_WINDOWEVENT_HIDDEN),
                          window(SDL_WINDOWEVENT_MINIMIZED), window(SDL_WINDOWEVENT_RESTORED),
                          window(SDL_WINDOWEVENT_SHOWN)}),
                ElementsAre("display gone", "display back"));
    EXPECT_THAT(take(in, {display()}), IsEmpty());
    displays_ = 0;
    EXPECT_THAT(take(in, {display(), window(SDL_WINDOWEVENT_SHOWN)}), ElementsAre("display gone"));
    displays_ = 1;
    EXPECT_THAT(take(in, {display()}), ElementsAre("display back"));
}

TEST_F(SdlInputTest, AHiddenWindowIsNotBackWithADisplay) {
    SdlInput in = input();
    EXPECT_THAT(take(in, {window(SDL_WINDOWEVENT_MINIMIZED), display()}), ElementsAre("display gone"));
    EXPECT_THAT(take(in, {window(SDL_WINDOWEVENT_RESTORED)}), ElementsAre("display back"));
}

TEST_F(SdlInputTest, NoFingerOutlivesTheDisplay) {
    SdlInput in = input();
    EXPECT_THAT(take(in, {finger(SDL_FINGERDOWN, 1, 0, 0), window(SDL_WINDOWEVENT_HIDDEN),
                          finger(SDL_FINGERUP, 1, 0, 0)}),
                ElementsAre("down 0 0.5 0.5", "cancel 0 0.5 0.5", "display gone"));
}

TEST_F(SdlInputTest, TheCursorIsTheMouses) {
    SdlInput in = input();
    EXPECT_FALSE(cursor_);
    take(in, {motion(5, 5, 0)}); // a window opened under a mouse that rests
    EXPECT_FALSE(cursor_);
    take(in, {motion(5, 5)});
    EXPECT_TRUE(cursor_);
    take(in, {finger(SDL_FINGERDOWN, 1, 0, 0)});
    EXPECT_FALSE(cursor_);
    take(in, {motion(6, 5)});
    EXPECT_TRUE(cursor_);
}

} // namespace
} // namespace metamer
