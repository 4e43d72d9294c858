#include "base/files.h"

#include <filesystem>
#include <functional>
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/error.h"

namespace metamer {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class Files : public testing::Test {
protected:
    Files() : folder_(fs::temp_directory_path() / ("metamer-files-" + std::to_string(::getpid()))) {
        fs::create_directories(folder_);
    }
    ~Files() override { fs::remove_all(folder_); }

    std::size_t entries() const {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
    }

    fs::path folder_;
};

std::string message_of(const std::function<void()>& call) {
    try {
        call();
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

// Reading it would wait for somebody who writes.
TEST_F(Files, APipeIsNotRead) {
    const fs::path pipe = folder_ / "pipe.csv";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_THAT(message_of([&] { read_file(pipe, 100); }), HasSubstr("pipe.csv: it is a pipe"));
    EXPECT_THAT(message_of([] { read_file("/dev/null", 100); }),
                HasSubstr("/dev/null: it is a pipe or a device"));
}

TEST_F(Files, WhatIsWrittenIsRead) {
    const std::string bytes("a\0b\n\xff", 5);
    write_file(folder_ / "f", bytes);
    EXPECT_EQ(read_file(folder_ / "f"), bytes);
    EXPECT_EQ(entries(), 1u) << "the part file is gone";
}

TEST_F(Files, WritingReplaces) {
    write_file(folder_ / "f", "long text");
    write_file(folder_ / "f", "short");
    EXPECT_EQ(read_file(folder_ / "f"), "short");
}

TEST_F(Files, RefusesByName) {
    EXPECT_THAT(message_of([&] { read_file(folder_ / "none"); }), HasSubstr("none: there is no such file"));
    EXPECT_THAT(message_of([&] { read_file(folder_); }), HasSubstr("it is a folder"));
    EXPECT_THAT(message_of([&] { write_file(folder_ / "no" / "f", "x"); }), HasSubstr("there is no folder"));
    EXPECT_THAT(message_of([&] { write_file(folder_, "x"); }), HasSubstr("it is a folder"));
    EXPECT_EQ(entries(), 0u);
}

TEST_F(Files, RefusesWhatIsTooLong) {
    write_file(folder_ / "f", "12345");
    EXPECT_EQ(read_file(folder_ / "f", 5), "12345");
    EXPECT_THAT(message_of([&] { read_file(folder_ / "f", 4); }), HasSubstr("it is over 4 bytes"));
}

// A full disk: /dev/full takes no byte. Renaming onto it cannot be tried, so the failure must come from
// writing.
TEST_F(Files, AFailedWriteLeavesNothing) {
    const std::string link = (folder_ / ("f.part." + std::to_string(::getpid()))).string();
    fs::create_symlink("/dev/full", link);
    EXPECT_THAT(message_of([&] { write_file(folder_ / "f", std::string(1 << 20, 'x')); }),
                HasSubstr("cannot write"));
    EXPECT_EQ(entries(), 0u);
}

TEST_F(Files, ALinkStaysAndItsFileIsReplaced) {
    write_file(folder_ / "f", "old");
    fs::create_symlink("f", folder_ / "link");
    write_file(folder_ / "link", "new");
    EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
    EXPECT_EQ(read_file(folder_ / "f"), "new");
    EXPECT_EQ(entries(), 2u);
}

TEST_F(Files, ADeviceIsWrittenToAsItStands) {
    fs::create_symlink("/dev/full", folder_ / "full");
    EXPECT_THAT(message_of([&] { write_file(folder_ / "full", "x"); }),
                HasSubstr("full: No space left on device"));
    EXPECT_TRUE(fs::is_symlink(folder_ / "full"));
    EXPECT_EQ(entries(), 1u);
}

} // namespace
} // namespace metamer
