// The exhibit under Wayland: Weston's kiosk shell, itself a window on an X server. Weston's own headless
// screen will not do: it has no seat, and SDL 2.26 crashes where there is none.
#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include "base/files.h"
#include "screens/on_screen.h"

namespace metamer {
namespace {

using test::Json;
using test::widget;

constexpr PxSize kScreen{800, 480};
constexpr const char* kSocket = "wayland-kiosk";

class Wayland : public test::OnScreen {
protected:
    void SetUp() override {
        ASSERT_EQ(test::missing("weston", "weston"), "");
        OnScreen::SetUp();
    }
    ~Wayland() override {
        kiosk_.reset();
        if (weston_ > 0) {
            kill(weston_, SIGTERM);
            waitpid(weston_, nullptr, 0);
        }
    }

    /// Weston over the whole X screen; waits until it takes clients.
    void start_weston() {
        std::filesystem::permissions(folder_, std::filesystem::perms::owner_all); // as it demands
        const std::string log = folder_ / "weston.txt", socket = std::string("--socket=") + kSocket;
        const std::string width = "--width=" + std::to_string(kScreen.width_px);
        const std::string height = "--height=" + std::to_string(kScreen.height_px);
        weston_ = fork();
        if (weston_ == 0) {
            prctl(PR_SET_PDEATHSIG, SIGKILL);
            setenv("XDG_RUNTIME_DIR", folder_.c_str(), 1);
            const int out = open(log.c_str(), O_WRONLY | O_CREAT, 0600);
            dup2(out, 1);
            dup2(out, 2);
            execlp("weston", "weston", "--no-config", "--backend=x11-backend.so", "--shell=kiosk-shell.so",
                   "--use-pixman", "--idle-time=0", socket.c_str(), width.c_str(), height.c_str(), nullptr);
            _exit(127);
        }
        for (int i = 0; i < 2000 && !std::filesystem::exists(folder_ / kSocket); ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        ASSERT_TRUE(std::filesystem::exists(folder_ / kSocket)) << read_file(log);
    }

    /// SDL 2.26 keeps a kilobyte of what it asked the compositor for.
    std::map<std::string, std::string> environment() const {
        const std::filesystem::path known = folder_ / "leaks.txt";
        write_file(known, "leak:libSDL2\nleak:libwayland-client\n");
        return {{"XDG_RUNTIME_DIR", folder_},
                {"WAYLAND_DISPLAY", kSocket},
                {"SDL_VIDEODRIVER", "wayland"},
                {"LSAN_OPTIONS", "print_suppressions=0:suppressions=" + known.string()}};
    }

    pid_t weston_ = -1;
};

TEST_F(Wayland, AppearsActsAndEnds) {
    open_screen(kScreen);
    start_weston();
    start_kiosk(test::kPatches, 0, environment());
    EXPECT_THAT(kiosk_->log(), testing::HasSubstr("driver=wayland"));
    const Json told = kiosk_->await("the whole screen", [](const Json& now) {
        return now.at("width_px") == kScreen.width_px && now.at("height_px") == kScreen.height_px;
    });
    expect_all_inside(told);
    EXPECT_EQ(wrong_colors(), "");
    tap("lamp", 2);
    kiosk_->await("A2800", [](const Json& now) { return widget(now, "lamp", 2).at("on"); });
    EXPECT_EQ(wrong_colors({"lamp.1.spectrum=A2800"}), "");
    EXPECT_EQ(kiosk_->end_by(SIGTERM), 0) << kiosk_->log();
}

/// The screen comes after the exhibit was changed.
TEST_F(Wayland, ShowsWhatChangedWhileItWaited) {
    open_screen(kScreen);
    write_exhibit(test::kPatches);
    kiosk_.emplace(folder_, std::vector<std::string>{"--wait", "exhibit.ini"}, environment());
    kiosk_->await_log("event=no_display");
    std::string text = std::string("[display]\nrotation = 90\n") + test::kPatches;
    const std::string written = "lamps = D65, F11, A2800";
    text.replace(text.find(written), written.size(), "lamps = A2800, F11, D65");
    write_exhibit(text);
    start_weston();
    const Json told = kiosk_->await("another first lamp, upright", [](const Json& now) {
        return widget(now, "lamp", 0).at("text") == "Light bulb" && now.at("height_px") == kScreen.width_px;
    });
    expect_all_inside(told);
    EXPECT_EQ(kiosk_->end_by(SIGTERM), 0) << kiosk_->log();
}

} // namespace
} // namespace metamer
