// The stage on a driver that SDL can only poll, as it does KMSDRM; `offscreen` needs no hardware.
#include <SDL.h>
#include <gmock/gmock.h>
#include <linux/netlink.h>
#include <sys/socket.h>
#include <thread>

#include "gles2/gl_test.h"
#include "service/descriptor.h"
#include "service/temporary_folder.h"
#include "window/event_text.h"
#include "window/sdl_stage.h"
#include "window/wakes.h"

namespace metamer {
namespace {

using test::texts;
using testing::ElementsAre;
using testing::IsEmpty;

constexpr double kLong_s = 30;

class PolledWindow : public testing::Test {
protected:
    PolledWindow() { plug("connected"); }

    void plug(const std::string& status) {
        std::filesystem::create_directory(connectors_ / "card0-HDMI-A-1");
        test::write(connectors_ / "card0-HDMI-A-1" / "status", status + "\n");
    }
    /// A window that has nothing to tell.
    std::unique_ptr<SdlStage> open() {
        auto stage =
            std::make_unique<SdlStage>(WindowOptions{.width_px = 64, .height_px = 48}, connectors_.path());
        EXPECT_TRUE(stage->open());
        EXPECT_EQ(stage->driver(), "offscreen");
        while (!stage->wait(0).empty()) {
        }
        return stage;
    }

    test::Environment driver_{"SDL_VIDEODRIVER", "offscreen"};
    test::TemporaryFolder connectors_;
};

/// Nothing there to be listened to: SDL is asked twenty times a second.
TEST_F(PolledWindow, WakesSeldom) {
    const auto stage = open();
    const long before = test::wakes();
    stage->wait(0.5);
    EXPECT_LT(test::wakes() - before, 20); // SDL itself: 500
}

/// A descriptor as SDL opens it under KMSDRM, which says nothing.
TEST_F(PolledWindow, SleepsWhereInputCanWakeIt) {
    const Descriptor uevents(socket(AF_NETLINK, SOCK_RAW | SOCK_CLOEXEC, NETLINK_KOBJECT_UEVENT));
    if (uevents.get() < 0)
        GTEST_SKIP() << "no netlink here";
    const auto stage = open();
    const long before = test::wakes();
    stage->wait(1.5);
    EXPECT_LT(test::wakes() - before, 10); // without it 30
}

/// What wakes it is the post, not the next look at the connectors, which would find one of them unplugged.
TEST_F(PolledWindow, APostWakesIt) {
    const Descriptor uevents(socket(AF_NETLINK, SOCK_RAW | SOCK_CLOEXEC, NETLINK_KOBJECT_UEVENT));
    std::vector<std::string> told;
    // More than once, as a busy machine may take a second from open() to post().
    for (int i = 0; i < 5 && told != std::vector<std::string>{"files changed"}; ++i) {
        plug("connected");
        const auto stage = open();
        plug("disconnected");
        std::thread other([&] { stage->post(FilesChangedEvent{}); });
        told = texts(stage->wait(-1));
        other.join();
    }
    EXPECT_THAT(told, ElementsAre("files changed"));
}

/// From the plug that is pulled to the first frame on another display.
TEST_F(PolledWindow, TellsOfItsDisplay) {
    const auto stage = open();
    SDL_Event press{};
    press.type = SDL_MOUSEBUTTONDOWN;
    press.button.button = SDL_BUTTON_LEFT;
    SDL_PushEvent(&press);
    EXPECT_THAT(texts(stage->wait(0)), ElementsAre("down 0 0.5 0.5"));
    plug("disconnected");
    EXPECT_THAT(texts(stage->wait(kLong_s)), ElementsAre("cancel 0 0.5 0.5", "display gone"));
    EXPECT_THAT(texts(stage->wait(1.5)), IsEmpty());
    EXPECT_FALSE(stage->context_lost());
    plug("connected");
    EXPECT_THAT(texts(stage->wait(kLong_s)), ElementsAre("context lost"));
    EXPECT_TRUE(stage->context_lost());
    stage->rebuild();
    EXPECT_FALSE(stage->context_lost());
    EXPECT_THAT(texts(stage->wait(kLong_s)), ElementsAre("display back"));
    plug("disconnected"); // and the new one is looked at again
    EXPECT_THAT(texts(stage->wait(kLong_s)), ElementsAre("display gone"));
}

TEST_F(PolledWindow, GoesOnWhereNoConnectorTells) {
    plug("unknown");
    const auto stage = open();
    plug("disconnected");
    EXPECT_THAT(texts(stage->wait(1.5)), IsEmpty());
}

} // namespace
} // namespace metamer
