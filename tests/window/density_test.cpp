#include "window/density.h"

#include <cmath>
#include <gtest/gtest.h>

namespace metamer {
namespace {

TEST(DensityOfDiagonal, IsPixelsOverMillimetres) {
    // 3 : 4 : 5: 400 px by 300 px over 10 inches.
    EXPECT_DOUBLE_EQ(px_per_mm_of_diagonal(400, 300, 10), 500 / 254.0);
    // 1920 x 1080 at 21.5 inches: a pixel pitch of 0.248 mm, as data sheets say.
    EXPECT_NEAR(px_per_mm_of_diagonal(1920, 1080, 21.5), 1 / 0.248, 0.01);
    EXPECT_EQ(px_per_mm_of_diagonal(1920, 1080, 0), 0);
}

TEST(DensityOfDpi, IsBelievedWhereItCanBeTrue) {
    EXPECT_DOUBLE_EQ(px_per_mm_of_dpi(96, 96), 96 / 25.4);
    EXPECT_DOUBLE_EQ(px_per_mm_of_dpi(100, 104), 102 / 25.4);
    EXPECT_DOUBLE_EQ(px_per_mm_of_dpi(25.4, 25.4), 1);
    EXPECT_DOUBLE_EQ(px_per_mm_of_dpi(762, 762), 30);
}

TEST(DensityOfDpi, IsNotBelievedElsewhere) {
    EXPECT_EQ(px_per_mm_of_dpi(0, 0), 0);
    EXPECT_EQ(px_per_mm_of_dpi(25, 25), 0);
    EXPECT_EQ(px_per_mm_of_dpi(763, 763), 0);
    EXPECT_EQ(px_per_mm_of_dpi(96, 160), 0);
    EXPECT_EQ(px_per_mm_of_dpi(160, 96), 0);
    EXPECT_EQ(px_per_mm_of_dpi(-96, -96), 0);
    // 1920 x 1080 px on a display that says 16 mm x 9 mm.
    EXPECT_EQ(px_per_mm_of_dpi(1920 * 25.4 / 16, 1080 * 25.4 / 9), 0);
    EXPECT_EQ(px_per_mm_of_dpi(std::nan(""), 96), 0);
    EXPECT_EQ(px_per_mm_of_dpi(INFINITY, INFINITY), 0);
}

} // namespace
} // namespace metamer
