#include "report/number_text.h"

#include <limits>

#include <gtest/gtest.h>

namespace metamer {
namespace {

TEST(ShortNumber, IsPlainWhereItIsShort) {
    EXPECT_EQ(short_number(0), "0");
    EXPECT_EQ(short_number(0.5), "0.5");
    EXPECT_EQ(short_number(12.3456), "12.3");
    EXPECT_EQ(short_number(1234567, 2), "1.2·10⁶");
    EXPECT_EQ(short_number(123456), "123000");
    EXPECT_EQ(short_number(0.0001), "0.0001");
    EXPECT_EQ(short_number(2e-5), "2·10⁻⁵");
    EXPECT_EQ(short_number(1e-10), "10⁻¹⁰");
    EXPECT_EQ(short_number(-3), "\u22123");
}

TEST(ShortNumber, RoundsIntoTheNextDecade) {
    EXPECT_EQ(short_number(9.996), "10");
    EXPECT_EQ(short_number(0.09996), "0.1");
    EXPECT_EQ(short_number(999999), "10⁶");
}

TEST(ShortNumber, HoldsForEveryDouble) {
    EXPECT_EQ(short_number(std::numeric_limits<double>::max(), 2), "1.8·10³⁰⁸");
    EXPECT_EQ(short_number(std::numeric_limits<double>::denorm_min(), 1), "5·10⁻³²⁴");
}

} // namespace
} // namespace metamer
