#include "base/numbers.h"

#include <gtest/gtest.h>

namespace metamer {
namespace {

TEST(ParseNumber, TakesDecimalNumbers) {
    EXPECT_EQ(parse_number("589.3"), 589.3);
    EXPECT_EQ(parse_number(" -1e-3 "), -1e-3);
    EXPECT_EQ(parse_number("+2"), 2);
}

TEST(ParseNumber, TakesNothingElse) {
    for (const char* text :
         {"", " ", "nan", "inf", "-inf", "1,5", "0x10", "1.5 nm", "1e999", "--1", "+-1", "1 2"})
        EXPECT_FALSE(parse_number(text)) << text;
}

TEST(ParseWhole, TakesWholeNumbersInRange) {
    EXPECT_EQ(parse_whole("640"), 640);
    for (const char* text : {"", "1.0", "1e3", "99999999999", "x"})
        EXPECT_FALSE(parse_whole(text)) << text;
}

TEST(ToText, ReadsBackAsTheSame) {
    for (double value : {0.1, 589.3, 1e-7, 1.0 / 3, 12345678.9, 0.0, -2.0})
        EXPECT_EQ(parse_number(to_text(value)), value) << to_text(value);
    EXPECT_EQ(to_text(0.1), "0.1");
}

} // namespace
} // namespace metamer
