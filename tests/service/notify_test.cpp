#include "service/notify.h"

#include <cstdlib>
#include <gmock/gmock.h>
#include <unistd.h>

#include "service/notify_socket.h"

namespace metamer {
namespace {

using testing::Eq;
using testing::Optional;
using namespace std::chrono_literals;

class NotifyTest : public testing::Test {
protected:
    void SetUp() override { setenv("NOTIFY_SOCKET", systemd_.path().c_str(), 1); }
    void TearDown() override { unsetenv("NOTIFY_SOCKET"); }
    std::string heard() const { return systemd_.heard(); }

private:
    test::NotifySocket systemd_;
};

TEST_F(NotifyTest, SpeaksSystemdsWords) {
    notify_ready();
    EXPECT_EQ(heard(), "READY=1");
    notify_stopping();
    EXPECT_EQ(heard(), "STOPPING=1");
    EXPECT_EQ(heard(), "");
}

TEST_F(NotifyTest, SaysWhenItReloads) {
    notify_reloading();
    EXPECT_THAT(heard(), testing::MatchesRegex("RELOADING=1\nMONOTONIC_USEC=[1-9][0-9]*"));
}

TEST_F(NotifyTest, SaysWhatItDoes) {
    notify_waiting();
    EXPECT_EQ(heard(), "STATUS=waiting for a screen");
    notify_running();
    EXPECT_EQ(heard(), "STATUS=running");
}

/// What systemd waits for a sign of life, for as long as it stands.
class Watched {
public:
    explicit Watched(const char* usec) { setenv("WATCHDOG_USEC", usec, 1); }
    Watched(const Watched&) = delete;
    Watched& operator=(const Watched&) = delete;
    ~Watched() {
        unsetenv("WATCHDOG_USEC");
        unsetenv("WATCHDOG_PID");
    }
};

/// Told in each of many turns it fills no queue; told as seldom as interval() says it is never late.
TEST_F(NotifyTest, SaysThatItLivesInItsTime) {
    const Watched watched("20000000");
    std::chrono::steady_clock::time_point now{1h};
    AliveSign sign([&] { return now; });
    const auto told_after = [&](std::chrono::milliseconds pause) {
        now += pause;
        sign.tell();
        return heard();
    };
    EXPECT_EQ(told_after(0ms), "WATCHDOG=1");
    int signs = 0;
    for (int turn = 0; turn < 1000; ++turn)
        signs += told_after(20ms) == "WATCHDOG=1";
    EXPECT_EQ(signs, 4);
    EXPECT_EQ(told_after(4999ms), "");
    EXPECT_EQ(told_after(*sign.interval()), "WATCHDOG=1") << "15 s after the last";
    EXPECT_EQ(told_after(*sign.interval()), "WATCHDOG=1");
}

TEST_F(NotifyTest, SaysNothingOfLifeWhereNobodyWatches) {
    AliveSign sign;
    sign.tell();
    EXPECT_EQ(heard(), "");
    EXPECT_EQ(sign.interval(), std::nullopt);
}

TEST_F(NotifyTest, AsksOnceWhetherItIsWatched) {
    {
        const Watched watched("4000");
        notify_alive();
        EXPECT_EQ(heard(), "WATCHDOG=1");
    }
    EXPECT_THAT(alive_interval(), Optional(2ms));
}

TEST(Notify, WithoutSystemdNothingHappens) {
    unsetenv("NOTIFY_SOCKET");
    notify_ready();
    setenv("NOTIFY_SOCKET", "/nowhere/at/all", 1);
    notify_stopping();
    unsetenv("NOTIFY_SOCKET");
}

TEST(AliveSign, IsDueInHalfOfWhatSystemdWaits) {
    const Watched watched("10000000");
    EXPECT_THAT(AliveSign().interval(), Optional(5000ms));
    setenv("WATCHDOG_PID", std::to_string(getpid()).c_str(), 1);
    EXPECT_THAT(AliveSign().interval(), Optional(5000ms));
    setenv("WATCHDOG_PID", "1", 1); // another process is watched
    EXPECT_EQ(AliveSign().interval(), std::nullopt);
    unsetenv("WATCHDOG_PID");
    setenv("WATCHDOG_USEC", "1000", 1); // never 0, which would be always
    EXPECT_THAT(AliveSign().interval(), Optional(1ms));
    setenv("WATCHDOG_USEC", "soon", 1);
    EXPECT_EQ(AliveSign().interval(), std::nullopt);
    unsetenv("WATCHDOG_USEC");
    EXPECT_EQ(AliveSign().interval(), std::nullopt);
}

} // namespace
} // namespace metamer
