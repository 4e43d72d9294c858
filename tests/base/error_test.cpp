#include "base/error.h"

#include <gtest/gtest.h>

namespace metamer {
namespace {

TEST(Error, IsOneSentence) {
    const Error error = bad_input("read", "config/kiosk.ini:12", "strength = -1 is below 0");
    EXPECT_STREQ(error.what(), "cannot read config/kiosk.ini:12: strength = -1 is below 0");
    EXPECT_EQ(error.status(), Exit::bad_input);
    EXPECT_EQ(error.place(), "config/kiosk.ini:12");
    EXPECT_EQ(error.cause(), "strength = -1 is below 0");
}

// Found by scripts/fuzz: a value with an escape sequence colored the terminal, one with a CR hid the place.
TEST(Error, QuotesNoControlCharacters) {
    const Error error = bad_input("read", "k\x1b[2J.ini:1",
                                  "\"a\tb\rc\nd\x7f\" is no name; \xC2\x9B"
                                  "5m gr\xC3\xBCn \xC2\xB5");
    EXPECT_STREQ(error.what(), "cannot read k?[2J.ini:1: \"a?b?c?d?\" is no name; ?5m gr\xC3\xBCn \xC2\xB5");
    EXPECT_EQ(error.place(), "k?[2J.ini:1");
    EXPECT_EQ(bad_input("read", "k.ini", "\xC2").cause(), "\xC2"); // what is not UTF-8 stays
}

TEST(Error, StatusesAreTheContractsNumbers) {
    EXPECT_EQ(static_cast<int>(failure("write", "a", "b").status()), 1);
    EXPECT_EQ(static_cast<int>(bad_input("read", "a", "b").status()), 2);
    EXPECT_EQ(static_cast<int>(no_gl("open", "a", "b").status()), 3);
}

} // namespace
} // namespace metamer
