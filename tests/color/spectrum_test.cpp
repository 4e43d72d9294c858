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

TEST(Curve, OfValuesOnTheGridHasThemAtItsWavelengths) {
    std::array<double, kIntervals> values{};
    values.front() = 1;
    values.back() = 3;
    const Curve curve = curve_of(values, 0.5);
    ASSERT_EQ(curve.value.size(), kIntervals);
    EXPECT_EQ(value_at_held(curve, 385), 0.5);
    EXPECT_EQ(value_at_held(curve, 390), 0);
    EXPECT_EQ(value_at_held(curve, 700), 1.5);
    EXPECT_EQ(curve_of(values).value.back(), 3);
}

} // namespace
} // namespace metamer
