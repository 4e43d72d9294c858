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

TEST(Error, StatusesAreTheContractsNumbers) {
    EXPECT_EQ(static_cast<int>(failure("write", "a", "b").status()), 1);
    EXPECT_EQ(static_cast<int>(bad_input("read", "a", "b").status()), 2);
    EXPECT_EQ(static_cast<int>(no_gl("open", "a", "b").status()), 3);
}

} // namespace
} // namespace metamer
