#include <EGL/egl.h>
#include <GLES2/gl2.h>
#include <SDL.h>
#include <csignal>
#include <filesystem>
#include <gmock/gmock.h>
#include <thread>

#include "base/error.h"
#include "gles/extensions.h"
#include "gles2/gl_test.h"
#include "service/signals.h"
#include "window/wakes.h"
#include "window/window_on_x.h"

namespace metamer {
namespace {

using test::Environment;
using testing::Contains;
using testing::ElementsAre;
using testing::StartsWith;

class Window : public test::WindowOnX {};

TEST_F(Window, FillsTheScreenAndShowsWhatIsDrawn) {
    const auto stage = open();
    EXPECT_EQ(stage->surface_width_px(), 320);
    EXPECT_EQ(stage->surface_height_px(), 240);
    EXPECT_EQ(stage->driver(), "x11");
    EXPECT_THAT(reinterpret_cast<const char*>(glGetString(GL_VERSION)), StartsWith("OpenGL ES "));
    test::show_color(*stage, 0, 1, 0.2F);
    glFinish();
    for (const auto& [x, y] : {std::pair{0, 0}, std::pair{319, 0}, std::pair{0, 239}, std::pair{319, 239}})
        EXPECT_THAT(screen_->pixel(x, y), ElementsAre(0, 255, 51)) << x << ' ' << y;
}

TEST_F(Window, HasDepthAndNoMoreThanItAskedFor) {
    const auto stage = open();
    GLint depth = 0, samples = -1;
    glGetIntegerv(GL_DEPTH_BITS, &depth);
    glGetIntegerv(GL_SAMPLES, &samples);
    EXPECT_GE(depth, 16);
    EXPECT_EQ(samples, 0);
}

TEST_F(Window, HasTheSizeThatIsAskedFor) {
    const auto stage = open({.width_px = 200, .height_px = 100, .rotation_deg = 90, .diagonal_in = 5});
    EXPECT_EQ(stage->surface_width_px(), 200);
    EXPECT_EQ(stage->surface_height_px(), 100);
    EXPECT_EQ(stage->rotation_deg(), 90);
    // The screen's diagonal, not the window's: 3 : 4 : 5.
    EXPECT_DOUBLE_EQ(stage->px_per_mm(), 400 / (5 * 25.4));
}

TEST_F(Window, TellsItsNewSizeAsPeopleSeeIt) {
    const auto stage = open({.width_px = 200, .height_px = 100, .rotation_deg = 90});
    screen_->act({"windowsize", std::to_string(test::x_window()), "210", "120"});
    EXPECT_THAT(read_until(*stage, "resize 120x210"), Contains("resize 120x210").Times(1));
    EXPECT_EQ(stage->surface_width_px(), 210);
    stage->bind();
    GLint viewport[4] = {};
    glGetIntegerv(GL_VIEWPORT, viewport);
    EXPECT_THAT(viewport, ElementsAre(0, 0, 210, 120));
}

TEST_F(Window, ClosesOnce) {
    const auto stage = open();
    screen_->ask_to_close(test::x_window());
    std::vector<std::string> batch; // whole: a second word for the same would come right after the first
    while (!testing::Matches(Contains("quit"))(batch))
        batch = test::texts(stage->wait(30));
    EXPECT_THAT(batch, Contains("quit").Times(1));
    EXPECT_THAT(test::texts(stage->wait(0)), testing::Not(Contains("quit")));
}

TEST_F(Window, LeavesSignalsToOthers) {
    const auto stage = open();
    for (const int signal : {SIGTERM, SIGINT}) {
        struct sigaction now {};
        sigaction(signal, nullptr, &now);
        EXPECT_EQ(now.sa_handler, SIG_DFL) << signal;
    }
}

TEST_F(Window, EndsOnSigterm) {
    Stage* shown = nullptr;
    OutsideWatch watch([&](Outside what) {
        if (what == Outside::quit)
            shown->post(QuitEvent{});
        else
            shown->post(ReloadEvent{});
    });
    const auto stage = open();
    shown = stage.get();
    kill(getpid(), SIGHUP);
    EXPECT_THAT(input_until(*stage, "reload"), ElementsAre("reload"));
    kill(getpid(), SIGTERM);
    EXPECT_THAT(input_until(*stage, "quit"), ElementsAre("quit"));
}

TEST_F(Window, APostWakesAWaitWithoutEnd) {
    const auto stage = open();
    stage->wait(0);
    std::thread other([&] { stage->post(FilesChangedEvent{}); });
    std::vector<std::string> all;
    while (!testing::Matches(Contains("files changed"))(all))
        all = test::texts(stage->wait(-1));
    other.join();
    EXPECT_THAT(all, Contains("files changed").Times(1));
}

/// Counts how often the thread slept: once a millisecond where SDL polls, a few times where it waits.
TEST_F(Window, WaitsAsleep) {
    const auto stage = open();
    while (!stage->wait(0.1).empty()) { // what the window's opening brings
    }
    const long before = test::wakes();
    stage->wait(0.5);
    EXPECT_LT(test::wakes() - before, 20);
}

TEST_F(Window, HasAContextThatTellsItsLoss) {
    const Environment all("METAMER_GL_EXTENSIONS", nullptr);
    const auto stage = open();
    if (!use_listed_extension(eglQueryString(eglGetCurrentDisplay(), EGL_EXTENSIONS),
                              "EGL_EXT_create_context_robustness"))
        GTEST_SKIP() << "this EGL has no EGL_EXT_create_context_robustness";
    GLint strategy = 0;
    glGetIntegerv(0x8256, &strategy); // GL_RESET_NOTIFICATION_STRATEGY_EXT
    EXPECT_EQ(strategy, 0x8252);      // GL_LOSE_CONTEXT_ON_RESET_EXT
    EXPECT_FALSE(stage->context_lost());
}

TEST_F(Window, DoesWithoutExtensions) {
    const Environment none("METAMER_GL_EXTENSIONS", "none");
    const auto stage = open();
    EXPECT_FALSE(stage->context_lost());
    test::show_color(*stage, 1, 1, 0);
    glFinish();
    EXPECT_THAT(screen_->pixel(5, 5), ElementsAre(255, 255, 0));
}

/// SDL makes its own context current where it makes a new surface.
TEST_F(Window, DrawsInItsOwnContextWhateverSdlDoes) {
    const auto stage = open();
    EGLContext own = eglGetCurrentContext();
    SDL_GL_MakeCurrent(SDL_GetWindowFromID(1), nullptr);
    SDL_GL_MakeCurrent(SDL_GetWindowFromID(1), SDL_GL_GetCurrentContext());
    stage->bind();
    EXPECT_EQ(eglGetCurrentContext(), own);
}

std::size_t open_files() {
    const std::filesystem::directory_iterator files("/proc/self/fd");
    return static_cast<std::size_t>(std::distance(begin(files), end(files)));
}

TEST_F(Window, IsRebuilt) {
    auto stage = open();
    stage->rebuild(); // what is opened once is open now
    const std::size_t files = open_files();
    for (int i = 0; i < 5; ++i) {
        GLuint texture = 0;
        glGenTextures(1, &texture);
        glBindTexture(GL_TEXTURE_2D, texture);
        stage->rebuild();
        EXPECT_FALSE(glIsTexture(texture));
        EXPECT_FALSE(stage->context_lost());
        EXPECT_EQ(open_files(), files);
    }
    for (int i = 0; i < 1000 && screen_->pixel(7, 7) != std::array{0, 0, 255}; ++i) {
        test::show_color(*stage, 0, 0, 1);
        stage->wait(0.01);
    }
    EXPECT_THAT(screen_->pixel(7, 7), ElementsAre(0, 0, 255));
    stage->post(ReloadEvent{});
    EXPECT_THAT(input_until(*stage, "reload"), ElementsAre("reload"));
}

/// A display that goes with the context, and somebody who does not wait for it.
TEST_F(Window, IsNotRebuiltWhereNobodyWaitsForADisplay) {
    int asked = 0;
    const auto stage = open({.wait_for_display = true, .still_waiting = [&](const std::string&) {
                                 ++asked;
                                 return false;
                             }});
    ASSERT_NE(stage, nullptr);
    const Environment no_x("DISPLAY", ":4711");
    EXPECT_FALSE(stage->rebuild());
    EXPECT_EQ(asked, 1);
}

/// Else nobody would draw again: a new window is shown from the start, and never says so.
TEST_F(Window, ThatWasHiddenIsBackWhenItIsMadeAnew) {
    const auto stage = open();
    SDL_HideWindow(SDL_GetWindowFromID(1));
    EXPECT_THAT(read_until(*stage, "display gone"), Contains("display gone"));
    stage->rebuild();
    EXPECT_THAT(read_until(*stage, "display back"), Contains("display back").Times(1));
}

std::string error_of(const WindowOptions& options) {
    try {
        open_window(options);
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), Exit::no_gl);
        return error.what();
    }
    return "opened";
}

TEST(NoWindow, SaysWhatWasTried) {
    const Environment no_x("DISPLAY", nullptr), no_wayland("WAYLAND_DISPLAY", nullptr),
        no_folder("XDG_RUNTIME_DIR", nullptr);
    {
        const Environment both("SDL_VIDEODRIVER", "x11,wayland");
        EXPECT_EQ(error_of({}), "cannot open a window: x11: x11 not available, DISPLAY is not set; "
                                "wayland: XDG_RUNTIME_DIR is not set, WAYLAND_DISPLAY is not set");
    }
    const Environment other("SDL_VIDEODRIVER", "teletype");
    EXPECT_EQ(error_of({}), "cannot open a window: teletype: teletype not available");
    const Environment wrong("DISPLAY", ":4711"), x("SDL_VIDEODRIVER", "x11");
    EXPECT_EQ(error_of({}), "cannot open a window: x11: x11 not available, DISPLAY=:4711");
}

TEST(NoWindow, WaitsUntilItIsToldNotTo) {
    const Environment no_x("DISPLAY", nullptr), x("SDL_VIDEODRIVER", "x11");
    int asked = 0;
    const auto stage = open_window({.wait_for_display = true, .still_waiting = [&](const std::string& error) {
                                        EXPECT_THAT(error, StartsWith("cannot open a window: x11: "));
                                        return ++asked < 3;
                                    }});
    EXPECT_EQ(stage, nullptr);
    EXPECT_EQ(asked, 3);
}

TEST(XScreen, NamesThePackageOfWhatItMisses) {
    EXPECT_EQ(test::missing("Xvbf", "xvfb"), "Xvbf is missing: apt-get install xvfb");
    EXPECT_EQ(test::missing("sh", "dash"), "");
}

TEST(NoWindow, ComesWithTheDisplay) {
    ASSERT_EQ(test::missing_for_x(), "");
    const Environment no_x("DISPLAY", nullptr), x("SDL_VIDEODRIVER", "x11");
    std::optional<test::XScreen> screen;
    const auto stage = open_window({.wait_for_display = true, .still_waiting = [&](const std::string&) {
                                        if (!screen)
                                            screen.emplace(160, 120);
                                        return true;
                                    }});
    ASSERT_NE(stage, nullptr);
    EXPECT_EQ(stage->surface_width_px(), 160);
}

} // namespace
} // namespace metamer
