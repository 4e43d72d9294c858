#include "base/utf8.h"

#include <gtest/gtest.h>

namespace metamer {
namespace {

using namespace std::string_literals;

TEST(Utf8, TakesEveryLengthOfSequence) {
    EXPECT_TRUE(is_utf8(""));
    EXPECT_TRUE(is_utf8("F11"));
    EXPECT_TRUE(is_utf8("\xC3\xA9"));         // U+00E9
    EXPECT_TRUE(is_utf8("\xE2\x82\xAC"));     // U+20AC
    EXPECT_TRUE(is_utf8("\xF0\x9F\x92\xA1")); // U+1F4A1
    EXPECT_TRUE(is_utf8("\xF4\x8F\xBF\xBF")); // U+10FFFF
    EXPECT_TRUE(is_utf8("\xED\x9F\xBF"));     // U+D7FF, the last before the surrogates
    EXPECT_TRUE(is_utf8("\xEE\x80\x80"));     // U+E000, the first after them
}

// The malformed forms of RFC 3629 section 4 and of Kuhn's decoder test.
TEST(Utf8, RefusesWhatIsMalformed) {
    for (const std::string& bad :
         {"\x80"s, "\xC3"s, "\xE2\x82"s, "\xF0\x9F\x92"s, "\xC3("s, "\xE2(\xAC"s, "\xE2\x82("s, "\xC0\x80"s,
          "\xC1\xBF"s, "\xE0\x9F\xBF"s, "\xF0\x8F\xBF\xBF"s, "\xED\xA0\x80"s, "\xF4\x90\x80\x80"s,
          "\xF5\x80\x80\x80"s, "\xFF"s})
        EXPECT_FALSE(is_utf8("a" + bad)) << ::testing::PrintToString(bad);
}

TEST(Utf8, FindsControlCharacters) {
    EXPECT_FALSE(has_control("Apricot, \xC3\xA9t\xC3\xA9 \xC2\xA0~")); // U+00A0 is none
    for (const std::string& bad : {"\t"s, "\n"s, "\0"s, "\x1B"s, "\x7F"s, "\xC2\x80"s, "\xC2\x9F"s})
        EXPECT_TRUE(has_control("a" + bad + "b")) << ::testing::PrintToString(bad);
}

TEST(Utf8, ConvertsLatin1) {
    EXPECT_EQ(utf8_from_latin1("a\x7F\x80\xE9\xFF"), "a\x7F\xC2\x80\xC3\xA9\xC3\xBF");
}

TEST(Utf8, CountsCodePoints) {
    EXPECT_EQ(code_points("\xC3\xA9t\xC3\xA9 \xF0\x9F\x92\xA1"), 5u);
}

TEST(Utf8, QuotesWithoutControlsAndCutAtACodePoint) {
    EXPECT_EQ(quotable("a\tb\xC2\x9B[2J\xC3\xA9"), "a?b?[2J\xC3\xA9");
    EXPECT_EQ(quotable("caf\xE9\xC3"), "caf??");
    EXPECT_EQ(quotable(std::string(40, 'x')), std::string(40, 'x'));
    EXPECT_EQ(quotable(std::string(41, 'x')), std::string(40, 'x') + "...");
    EXPECT_EQ(quotable(std::string(39, 'x') + "\xC3\xA9"), std::string(39, 'x') + "...");
}

TEST(WithoutControl, LeavesAllElseAsItIs) {
    EXPECT_EQ(without_control("a\tb\x1b[2J\x7f"), "a?b?[2J?");
    EXPECT_EQ(without_control("\xC2\x9B"
                              "31m"),
              "?31m")
        << "C1 has a CSI of its own";
    EXPECT_EQ(without_control("\xC2\xA0 \xC3\xBC"), "\xC2\xA0 \xC3\xBC");
    EXPECT_EQ(without_control("\xC2"
                              "A\xFF\xC2"),
              "\xC2"
              "A\xFF\xC2")
        << "nor what is no UTF-8";
}

} // namespace
} // namespace metamer
