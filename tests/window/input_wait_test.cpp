#include "window/input_wait.h"

#include <array>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <linux/netlink.h>
#include <memory>
#include <set>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <thread>

#include "service/temporary_folder.h"

namespace metamer {
namespace {

constexpr double kLong_s = 30, kShort_s = 0.001;

struct Pipe {
    Pipe() {
        std::array<int, 2> ends{};
        if (pipe(ends.data()) != 0)
            throw std::runtime_error("cannot make a pipe");
        out = std::make_unique<Descriptor>(ends[0]);
        in = std::make_unique<Descriptor>(ends[1]);
    }
    void put() const { EXPECT_EQ(write(in->get(), "x", 1), 1); }
    void take() const {
        char byte = 0;
        EXPECT_EQ(read(out->get(), &byte, 1), 1);
    }
    std::unique_ptr<Descriptor> out, in;
};

/// Pipes play the devices that SDL has open.
class InputWaitTest : public testing::Test {
protected:
    Pipe& open_device() {
        Pipe& made = *devices_.emplace_back(std::make_unique<Pipe>());
        numbers_.insert(made.out->get());
        return made;
    }

    std::vector<std::unique_ptr<Pipe>> devices_;
    std::set<int> numbers_;
    InputWait wait_{[this](int descriptor) { return numbers_.contains(descriptor); }};
};

TEST_F(InputWaitTest, InputEndsTheSleep) {
    open_device();
    const Pipe& touch = open_device();
    EXPECT_FALSE(wait_.sleep(kShort_s));
    touch.put();
    EXPECT_TRUE(wait_.sleep(kLong_s));
    touch.take(); // left to SDL, and still there
    EXPECT_FALSE(wait_.sleep(kShort_s));
    touch.put();
    EXPECT_TRUE(wait_.sleep(kLong_s));
}

/// A descriptor that SDL does not read would keep the processor busy.
TEST_F(InputWaitTest, RestsBetweenInputThatNobodyReads) {
    open_device().put();
    for (int i = 0; i < 3; ++i) {
        EXPECT_TRUE(wait_.sleep(kLong_s)) << i;
        EXPECT_FALSE(wait_.sleep(kLong_s)) << i;
    }
}

TEST_F(InputWaitTest, ADeviceThatIsOpenedLaterIsFound) {
    EXPECT_FALSE(wait_.sleep(kShort_s));
    open_device().put();
    EXPECT_TRUE(wait_.sleep(kLong_s));
}

TEST_F(InputWaitTest, ADeviceThatIsClosedIsForgotten) {
    Pipe& gone = open_device();
    const Pipe& stays = open_device();
    EXPECT_FALSE(wait_.sleep(kShort_s));
    gone.put();
    EXPECT_TRUE(wait_.sleep(kLong_s));
    numbers_.erase(gone.out->get());
    gone.out.reset();
    EXPECT_FALSE(wait_.sleep(kLong_s)); // a rest
    EXPECT_TRUE(wait_.sleep(kLong_s));  // the kernel says that it is closed
    EXPECT_FALSE(wait_.sleep(kLong_s));
    EXPECT_FALSE(wait_.sleep(kShort_s)); // and it is asked for no more
    stays.put();
    EXPECT_TRUE(wait_.sleep(kLong_s));
}

TEST_F(InputWaitTest, AWakeEndsTheSleepToComeAndNoOther) {
    open_device();
    wait_.wake();
    wait_.wake();
    EXPECT_TRUE(wait_.sleep(kLong_s));
    EXPECT_FALSE(wait_.sleep(kShort_s));
}

TEST_F(InputWaitTest, AWakeEndsASleepAndARest) {
    open_device().put();
    EXPECT_TRUE(wait_.sleep(kLong_s));
    wait_.wake();
    EXPECT_TRUE(wait_.sleep(kLong_s));
    devices_.front()->take();
    std::thread other([this] { wait_.wake(); });
    EXPECT_TRUE(wait_.sleep(kLong_s));
    other.join();
}

/// Nothing tells of input: SDL is to be asked now and then, whatever the caller would sleep.
TEST_F(InputWaitTest, SleepsShortlyWhereThereIsNothingToListenTo) {
    EXPECT_FALSE(wait_.sleep(1e9));
}

/// Open without being used: any device node will do, with or without a device.
bool brings_input_at(const std::filesystem::path& path) {
    const Descriptor opened(open(path.c_str(), O_PATH | O_CLOEXEC));
    EXPECT_GE(opened.get(), 0) << path;
    return brings_input(opened.get());
}

TEST(BringsInput, TheDevicesOfTheKernelsInput) {
    const test::TemporaryFolder folder;
    if (mknod((folder / "event0").c_str(), S_IFCHR | 0600, makedev(13, 64)) != 0)
        GTEST_SKIP() << "cannot make a device node here";
    EXPECT_TRUE(brings_input_at(folder / "event0"));
    ASSERT_EQ(mknod((folder / "disk").c_str(), S_IFBLK | 0600, makedev(13, 64)), 0);
    EXPECT_FALSE(brings_input_at(folder / "disk"));
}

TEST(BringsInput, WhatUdevTells) {
    const Descriptor uevents(socket(AF_NETLINK, SOCK_RAW | SOCK_CLOEXEC, NETLINK_KOBJECT_UEVENT));
    if (uevents.get() < 0)
        GTEST_SKIP() << "no netlink here";
    EXPECT_TRUE(brings_input(uevents.get()));
    const Descriptor routes(socket(AF_NETLINK, SOCK_RAW | SOCK_CLOEXEC, NETLINK_ROUTE));
    EXPECT_FALSE(brings_input(routes.get()));
    const Descriptor local(socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
    EXPECT_FALSE(brings_input(local.get()));
}

TEST(BringsInput, NothingElse) {
    EXPECT_FALSE(brings_input_at("/dev/null"));
    EXPECT_FALSE(brings_input_at("/"));
    EXPECT_FALSE(brings_input(-1));
    const Pipe pipe;
    EXPECT_FALSE(brings_input(pipe.out->get()));
}

} // namespace
} // namespace metamer
