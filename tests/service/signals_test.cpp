#include "service/signals.h"

#include <atomic>
#include <cerrno>
#include <condition_variable>
#include <csignal>
#include <gmock/gmock.h>
#include <mutex>
#include <sys/syscall.h>
#include <thread>
#include <unistd.h>

#include "base/error.h"
#include "service/temporary_folder.h"

namespace {
bool inotify_refused = false;
} // namespace

/// Before the C library's own. (RLIMIT_NOFILE would refuse descriptors to UBSan as well.)
extern "C" int inotify_init1(int flags) noexcept {
    if (!inotify_refused)
        return static_cast<int>(syscall(SYS_inotify_init1, flags));
    errno = EMFILE;
    return -1;
}

namespace metamer {
namespace {

using test::write;
using testing::ElementsAre;

/// What was told so far, and the next of it.
class Told {
public:
    OutsideWatch::Tell tell() {
        return [this](Outside what) {
            const std::lock_guard lock(mutex_);
            told_.push_back(what);
            more_.notify_all();
        };
    }
    /// Waits until so many were told; the minute is for a watch that never tells.
    std::vector<Outside> wait(std::size_t count) {
        std::unique_lock lock(mutex_);
        more_.wait_for(lock, std::chrono::minutes(1), [&] { return told_.size() >= count; });
        return told_;
    }

private:
    std::mutex mutex_;
    std::condition_variable more_;
    std::vector<Outside> told_;
};

TEST(OutsideWatch, TellsSignals) {
    Told told;
    OutsideWatch watch(told.tell());
    kill(getpid(), SIGHUP);
    EXPECT_THAT(told.wait(1), ElementsAre(Outside::reload));
    kill(getpid(), SIGTERM);
    EXPECT_THAT(told.wait(2), ElementsAre(Outside::reload, Outside::quit));
    kill(getpid(), SIGINT);
    EXPECT_THAT(told.wait(3), ElementsAre(Outside::reload, Outside::quit, Outside::quit));
}

TEST(OutsideWatch, LeavesTheSignalsAsTheyWere) {
    sigset_t before, during, after;
    pthread_sigmask(SIG_BLOCK, nullptr, &before);
    {
        OutsideWatch watch([](Outside) {});
        pthread_sigmask(SIG_BLOCK, nullptr, &during);
    }
    pthread_sigmask(SIG_BLOCK, nullptr, &after);
    for (const int signal : {SIGTERM, SIGINT, SIGHUP}) {
        EXPECT_EQ(sigismember(&before, signal), 0);
        EXPECT_EQ(sigismember(&during, signal), 1);
        EXPECT_EQ(sigismember(&after, signal), 0);
    }
}

TEST(OutsideWatch, ASignalOnTheWayOutDoesNotKill) {
    Told told;
    std::mutex busy;
    {
        std::unique_lock hold(busy);
        auto tell = told.tell();
        OutsideWatch watch([&, tell](Outside what) {
            tell(what);
            const std::lock_guard until_released(busy);
        });
        kill(getpid(), SIGTERM);
        told.wait(1); // the watch is inside tell() now
        kill(getpid(), SIGTERM);
        hold.unlock();
    }
    SUCCEED();
}

TEST(OutsideWatch, TellsFilesThatChange) {
    const test::TemporaryFolder folder;
    Told told;
    OutsideWatch watch(told.tell());
    ASSERT_TRUE(watch.watch(std::vector{folder / "kiosk.ini"}));
    write(folder / "kiosk.ini");
    EXPECT_THAT(told.wait(1), ElementsAre(Outside::changed));
    write(folder / "kiosk.ini.new");
    std::filesystem::rename(folder / "kiosk.ini.new", folder / "kiosk.ini");
    EXPECT_THAT(told.wait(2), ElementsAre(Outside::changed, Outside::changed));
}

TEST(OutsideWatch, GoesWithAFolderThatIsMadeAgain) {
    const test::TemporaryFolder folder;
    Told told;
    OutsideWatch watch(told.tell());
    EXPECT_FALSE(watch.watch(std::vector{folder / "config/kiosk.ini"}));
    std::filesystem::create_directory(folder / "config");
    EXPECT_EQ(told.wait(1).size(), 1U);
    write(folder / "config/kiosk.ini");
    EXPECT_EQ(told.wait(2).size(), 2U);
}

TEST(OutsideWatch, TellsABurstOnce) {
    const test::TemporaryFolder folder;
    Told told;
    OutsideWatch watch(told.tell());
    ASSERT_TRUE(watch.watch(std::vector{folder / "kiosk.ini"}));
    constexpr int kWrites = 50;
    for (int i = 0; i < kWrites; ++i)
        write(folder / "kiosk.ini", std::to_string(i));
    told.wait(1);
    kill(getpid(), SIGHUP);
    // A stalled machine may cut the burst; each write told by itself would be a watch without patience.
    const std::vector<Outside> all = told.wait(2);
    EXPECT_LT(all.size(), kWrites / 2);
    EXPECT_EQ(all.front(), Outside::changed);
}

/// Changes that never pause are told all the same.
TEST(OutsideWatch, TellsABurstWithoutEnd) {
    const test::TemporaryFolder folder;
    Told told;
    OutsideWatch watch(told.tell());
    ASSERT_TRUE(watch.watch(std::vector{folder / "kiosk.ini"}));
    std::atomic<bool> end = false;
    std::jthread writer([&] {
        while (!end)
            write(folder / "kiosk.ini");
    });
    EXPECT_THAT(told.wait(1), testing::Contains(Outside::changed));
    end = true;
}

TEST(OutsideWatch, SaysWhereTheKernelRefuses) {
    inotify_refused = true;
    std::string what = "nothing thrown";
    try {
        OutsideWatch watch([](Outside) {});
    } catch (const Error& error) {
        what = error.what();
    }
    inotify_refused = false;
    EXPECT_EQ(what, "cannot watch files: inotify_init1: Too many open files");
}

} // namespace
} // namespace metamer
