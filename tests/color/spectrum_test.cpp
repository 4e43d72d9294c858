#include "color/spectrum.h"

#include <gtest/gtest.h>

namespace metamer {
namespace {

const Curve kCurve{{400, 500, 520}, {1, 3, 2}};

TEST(Curve, IsLinearBetweenItsSamples) {
    EXPECT_EQ(value_at_held(kCurve, 400), 1);
    EXPECT_DOUBLE_EQ(value_at_held(kCurve, 425), 1.5);
    EXPECT_EQ(value_at_held(kCurve, 500), 3);
    EXPECT_DOUBLE_EQ(value_at_held(kCurve, 515), 2.25);
    EXPECT_EQ(value_at_held(kCurve, 520), 2);
}

TEST(Curve, HoldsItsEnds) {
    EXPECT_EQ(value_at_held(kCurve, 399.9), 1);
    EXPECT_EQ(value_at_held(kCurve, 520.1), 2);
    EXPECT_EQ(value_at_held({}, 450), 0);
}

} // namespace
} // namespace metamer
