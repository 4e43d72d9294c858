// Every input that the fuzzers were led to, once more. scripts/fuzz looks for new ones.
#include <cmath>
#include <filesystem>
#include <iostream>

#include <gtest/gtest.h>

#include "base/files.h"
#include "fuzz/must.h"

namespace metamer::fuzz {
namespace {

class Corpus : public testing::TestWithParam<Target> {};

// A target that is not satisfied aborts: the last file named is the one.
TEST_P(Corpus, IsTakenOrRefused) {
    const auto& [name, run] = GetParam();
    const std::filesystem::path folder =
        std::filesystem::path(METAMER_SOURCE_DIR) / "tests" / "fuzz" / "corpus" / name;
    int taken = 0, refused = 0;
    for (const auto& file : std::filesystem::directory_iterator(folder)) {
        std::cout << file.path().filename().string() << std::endl;
        ++(run(read_file(file.path())) == Outcome::taken ? taken : refused);
    }
    // Both ends are reached: the corpus is neither all harmless nor all caught by the first check.
    EXPECT_GT(taken, 3);
    EXPECT_GT(refused, 3);
}

INSTANTIATE_TEST_SUITE_P(Fuzz, Corpus, testing::ValuesIn(targets().begin(), targets().end()),
                         [](const auto& target) { return std::string(target.param.name); });

TEST(Must, AbortsWhereAPromiseIsNotKept) {
    must(true, "kept");
    EXPECT_DEATH(must(false, "one is two", "1"), "not kept: one is two: 1");
    EXPECT_DEATH(must_be_within(std::nan(""), 0, 1, "a share"), "a share: .*outside 0.* 1");
    EXPECT_DEATH(must_be_within(1.5, 0, 1, "a share"), "not kept: a share: 1.5");
}

TEST(Must, TakesBadInputOfOneLineOnly) {
    EXPECT_EQ(outcome_of([] {}), Outcome::taken);
    EXPECT_EQ(outcome_of([] { throw bad_input("read", "a.ini:1", "no"); }), Outcome::refused);
    EXPECT_DEATH(outcome_of([] { throw failure("read", "a.ini:1", "no"); }), "ends with status 2");
    EXPECT_DEATH(outcome_of([] { throw Error(Exit::bad_input, "no"); }), "verb, place and cause");
    EXPECT_DEATH(outcome_of([] { throw Error(Exit::bad_input, "read", "a\x1b", "no"); }),
                 "steers no terminal");
    EXPECT_ANY_THROW(outcome_of([] { throw std::bad_alloc(); }));
}

} // namespace
} // namespace metamer::fuzz
