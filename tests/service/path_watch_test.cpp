#include "service/path_watch.h"

#include <gtest/gtest.h>

#include "service/temporary_folder.h"

namespace metamer {
namespace {

namespace fs = std::filesystem;
using test::write;

/// The kernel tells of a change before the call that made it returns: nothing here waits.
class PathWatchTest : public testing::Test {
protected:
    PathWatchTest() {
        fs::create_directory(folder_ / "config");
        write(file_);
    }
    bool set(const fs::path& path) { return watch_.set(std::vector{path}); }
    /// Whether a change was told, and, as its reader does, looks where the path leads now.
    bool changed() {
        const bool ours = watch_.take_changes();
        watch_.look_again();
        return ours;
    }

    test::TemporaryFolder folder_;
    fs::path file_ = folder_ / "config/kiosk.ini";
    PathWatch watch_;
};

TEST_F(PathWatchTest, TellsWhatHappensToAFile) {
    ASSERT_TRUE(set(file_));
    EXPECT_FALSE(changed());
    write(file_, "other");
    EXPECT_TRUE(changed());
    EXPECT_FALSE(changed());
    fs::permissions(file_, fs::perms::owner_read);
    EXPECT_TRUE(changed());
    write(folder_ / "config/kiosk.ini.new");
    EXPECT_FALSE(changed());
    fs::rename(folder_ / "config/kiosk.ini.new", file_);
    EXPECT_TRUE(changed());
    fs::rename(file_, folder_ / "config/kiosk.ini.old");
    EXPECT_TRUE(changed());
    write(file_);
    EXPECT_TRUE(changed());
    fs::remove(file_);
    EXPECT_TRUE(changed());
    write(file_);
    EXPECT_TRUE(changed());
}

TEST_F(PathWatchTest, ReadingAndNeighborsAreNoChange) {
    ASSERT_TRUE(set(file_));
    std::string word;
    std::ifstream(file_) >> word;
    write(folder_ / "config/other.ini");
    write(folder_ / "config/kiosk.ini~");
    write(folder_ / "kiosk.ini");
    EXPECT_FALSE(changed());
}

TEST_F(PathWatchTest, AFileThatIsNotThereYet) {
    ASSERT_TRUE(set(folder_ / "config/later.ini"));
    write(folder_ / "config/later.ini");
    EXPECT_TRUE(changed());
}

TEST_F(PathWatchTest, AFolderStandsForItsFiles) {
    ASSERT_TRUE(set(folder_ / "config"));
    write(folder_ / "config/fr.ini");
    EXPECT_TRUE(changed());
    fs::remove(folder_ / "config/fr.ini");
    EXPECT_TRUE(changed());
    write(folder_ / "beside");
    EXPECT_FALSE(changed());
}

TEST_F(PathWatchTest, WhatIsSetReplacesWhatWas) {
    write(folder_ / "config/b.ini");
    ASSERT_TRUE(set(file_));
    ASSERT_TRUE(set(folder_ / "config/b.ini"));
    write(file_);
    EXPECT_FALSE(changed());
    write(folder_ / "config/b.ini");
    EXPECT_TRUE(changed());
    ASSERT_TRUE(watch_.set({}));
    write(folder_ / "config/b.ini");
    EXPECT_FALSE(changed());
}

/// Months of changed lists must not use up the kernel's watches.
TEST_F(PathWatchTest, KeepsNoWatchThatItDoesNotNeed) {
    const auto watches = [this] {
        std::ifstream info("/proc/self/fdinfo/" + std::to_string(watch_.descriptor()));
        int count = 0;
        for (std::string line; std::getline(info, line);)
            count += line.starts_with("inotify ") ? 1 : 0;
        return count;
    };
    ASSERT_TRUE(set(file_));
    const int before = watches();
    fs::create_directories(folder_ / "other/deep");
    ASSERT_TRUE(set(folder_ / "other/deep/a.ini"));
    EXPECT_EQ(watches(), before + 1);
    ASSERT_TRUE(set(file_));
    EXPECT_EQ(watches(), before);
}

TEST_F(PathWatchTest, SeveralInOneFolderAndInOthers) {
    fs::create_directory(folder_ / "atlas");
    const std::vector<fs::path> paths{file_, folder_ / "config/b.ini", folder_ / "atlas/a.png"};
    ASSERT_TRUE(watch_.set(paths));
    for (const fs::path& path : paths) {
        write(path);
        EXPECT_TRUE(changed()) << path;
    }
}

TEST_F(PathWatchTest, AFolderThatIsNotThereIsSaidAndAwaited) {
    EXPECT_FALSE(set(folder_ / "usb/stick/kiosk.ini"));
    write(folder_ / "beside");
    EXPECT_FALSE(changed());
    fs::create_directory(folder_ / "usb");
    EXPECT_TRUE(changed());
    fs::create_directory(folder_ / "usb/stick");
    EXPECT_TRUE(changed());
    EXPECT_TRUE(watch_.look_again());
    write(folder_ / "usb/stick/kiosk.ini");
    EXPECT_TRUE(changed());
}

TEST_F(PathWatchTest, TheOthersAreWatchedAllTheSame) {
    EXPECT_FALSE(watch_.set(std::vector{folder_ / "nowhere/a.ini", file_}));
    write(file_);
    EXPECT_TRUE(changed());
}

TEST_F(PathWatchTest, AFileInPlaceOfAFolder) {
    EXPECT_FALSE(set(file_ / "below.ini"));
    fs::remove(file_);
    EXPECT_TRUE(changed());
}

TEST_F(PathWatchTest, AFolderRemovedAndMadeAgain) {
    ASSERT_TRUE(set(file_));
    fs::remove_all(folder_ / "config");
    EXPECT_TRUE(changed());
    fs::create_directory(folder_ / "config");
    EXPECT_TRUE(changed());
    write(file_);
    EXPECT_TRUE(changed());
}

TEST_F(PathWatchTest, AFolderMovedAwayFarUp) {
    fs::create_directories(folder_ / "a/b/c");
    write(folder_ / "a/b/c/kiosk.ini");
    ASSERT_TRUE(set(folder_ / "a/b/c/kiosk.ini"));
    fs::rename(folder_ / "a", folder_ / "old");
    EXPECT_TRUE(changed());
    fs::create_directories(folder_ / "a/b/c");
    EXPECT_TRUE(changed());
    write(folder_ / "a/b/c/kiosk.ini");
    EXPECT_TRUE(changed());
    write(folder_ / "old/b/c/kiosk.ini");
    EXPECT_FALSE(changed());
}

TEST_F(PathWatchTest, ALinkedFolderAndItsLink) {
    fs::create_directory(folder_ / "next");
    fs::create_symlink("config", folder_ / "current");
    ASSERT_TRUE(set(folder_ / "current/kiosk.ini"));
    write(file_);
    EXPECT_TRUE(changed());
    // As releases are switched: a new link over the old one.
    fs::create_symlink(folder_ / "next", folder_ / "new");
    EXPECT_FALSE(changed());
    fs::rename(folder_ / "new", folder_ / "current");
    EXPECT_TRUE(changed());
    write(folder_ / "next/kiosk.ini");
    EXPECT_TRUE(changed());
    write(file_);
    EXPECT_FALSE(changed());
}

TEST_F(PathWatchTest, ALinkedFileAndItsLink) {
    fs::create_directory(folder_ / "data");
    write(folder_ / "data/real.ini");
    fs::create_symlink("../data/real.ini", folder_ / "config/link.ini");
    ASSERT_TRUE(set(folder_ / "config/link.ini"));
    write(folder_ / "data/real.ini");
    EXPECT_TRUE(changed());
    fs::remove(folder_ / "config/link.ini");
    EXPECT_TRUE(changed());
    write(folder_ / "data/real.ini");
    EXPECT_FALSE(changed());
}

TEST_F(PathWatchTest, LinksInACircleEnd) {
    fs::create_symlink("b", folder_ / "a");
    fs::create_symlink("a", folder_ / "b");
    EXPECT_FALSE(set(folder_ / "a/kiosk.ini"));
    fs::remove(folder_ / "b");
    EXPECT_TRUE(changed());
}

TEST_F(PathWatchTest, PathsFromTheCurrentFolderAndWithDots) {
    const fs::path before = fs::current_path();
    fs::current_path(folder_ / "config");
    const bool there = set("../config/./kiosk.ini");
    fs::current_path(before);
    EXPECT_TRUE(there);
    write(file_);
    EXPECT_TRUE(changed());
}

} // namespace
} // namespace metamer
