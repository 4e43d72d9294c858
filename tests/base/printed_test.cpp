#include "base/printed.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace metamer {
namespace {

TEST(Printed, IsWhatPrintfPrints) {
    EXPECT_EQ(printed("%-4s|%3d|%.2f %%|0x%04x", "ab", 7, 0.125, 0xabu), "ab  |  7|0.12 %|0x00ab");
    EXPECT_EQ(printed("%s", ""), "");
}

TEST(Printed, HasNoGreatestLength) {
    const std::string text(100000, 'x');
    EXPECT_EQ(printed("<%s>", text.c_str()), "<" + text + ">");
}

TEST(Printed, RefusesWhatTheCLibraryRefuses) {
    // No character of the C locale.
    const wchar_t unknown[] = {0x2603, 0};
    try {
        printed("%ls", unknown);
        FAIL() << "printed";
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "cannot print \"%ls\": the C library refuses it");
    }
}

} // namespace
} // namespace metamer
