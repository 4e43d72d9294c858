#include <SDL.h>
#include <gmock/gmock.h>

#include "window/window_on_x.h"

namespace metamer {
namespace {

using testing::ElementsAre;

class WindowInput : public test::WindowOnX {};

TEST_F(WindowInput, TheMouseDrags) {
    const auto stage = open();
    screen_->act({"mousemove", "100", "50", "mousedown", "1", "mousemove", "200", "150", "mouseup", "1"});
    EXPECT_THAT(input_until(*stage, "up 0 200.5 150.5"),
                ElementsAre("down 0 100.5 50.5", "move 0 200.5 150.5", "up 0 200.5 150.5"));
}

struct Turn {
    int rotation_deg;
    const char* down;
};

TEST_F(WindowInput, TheMouseIsTurnedWithThePicture) {
    for (const auto& [rotation_deg, wanted] :
         {Turn{90, "down 0 50.5 219.5"}, Turn{180, "down 0 219.5 189.5"}, Turn{270, "down 0 189.5 100.5"}}) {
        const auto stage = open({.rotation_deg = rotation_deg});
        screen_->act({"mousemove", "100", "50", "mousedown", "1"});
        EXPECT_THAT(input_until(*stage, wanted), ElementsAre(wanted)) << rotation_deg;
        screen_->act({"mouseup", "1"});
    }
}

TEST_F(WindowInput, TheMouseFollowsAScreenThatIsHungAnew) {
    const auto stage = open({.rotation_deg = 180});
    stage->hang(90, 5);
    EXPECT_EQ(stage->rotation_deg(), 90);
    EXPECT_DOUBLE_EQ(stage->px_per_mm(), 400 / (5 * 25.4)); // 3 : 4 : 5
    screen_->act({"mousemove", "100", "50", "mousedown", "1"});
    EXPECT_THAT(input_until(*stage, "down 0 50.5 219.5"), ElementsAre("down 0 50.5 219.5"));
    screen_->act({"mouseup", "1"});
}

TEST_F(WindowInput, Keys) {
    const auto stage = open();
    screen_->act({"key", "Left", "Right", "Up", "Down", "KP_Left", "KP_Right", "KP_Up", "KP_Down"});
    screen_->act({"key", "Return", "KP_Enter", "space", "Tab", "shift+Tab", "x", "Escape"});
    EXPECT_THAT(input_until(*stage, "key escape"),
                ElementsAre("key left", "key right", "key up", "key down", "key left", "key right", "key up",
                            "key down", "key enter", "key enter", "key enter", "key tab", "key back_tab",
                            "key escape"));
}

/// X of this kind has no touch screen: SDL is told of one.
TEST_F(WindowInput, ATouchHidesTheCursorAndTheMouseShowsIt) {
    const auto stage = open();
    screen_->act({"mousemove", "20", "20", "mousemove", "30", "30", "click", "1"});
    input_until(*stage, "up 0 30.5 30.5");
    EXPECT_EQ(SDL_ShowCursor(SDL_QUERY), SDL_ENABLE);
    SDL_Event touch{};
    touch.type = SDL_FINGERDOWN;
    touch.tfinger.touchId = 7;
    touch.tfinger.x = 1;
    SDL_PushEvent(&touch);
    EXPECT_THAT(input_until(*stage, "cancel 0 319.5 0.5"),
                ElementsAre("down 0 319.5 0.5", "cancel 0 319.5 0.5"))
        << "SDL, asked, knows of no such finger";
    EXPECT_EQ(SDL_ShowCursor(SDL_QUERY), SDL_DISABLE);
}

} // namespace
} // namespace metamer
