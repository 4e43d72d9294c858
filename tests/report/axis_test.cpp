#include "report/axis.h"

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <gmock/gmock.h>

#include "image/error_of.h"

namespace metamer {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr double kInf = std::numeric_limits<double>::infinity();

const Axis kLinear{.title = "x, nm"};
const Axis kLog{.title = "y", .scale = Scale::log10};

std::vector<std::string> labels(const Ticks& ticks) {
    std::vector<std::string> out;
    for (const Tick& tick : ticks.major)
        out.push_back(tick.label);
    return out;
}

TEST(FittedRange, HoldsAllValuesWithRoom) {
    const Range range = fitted_range(kLinear, std::vector{400.0, 500.0});
    EXPECT_DOUBLE_EQ(range.low, 395);
    EXPECT_DOUBLE_EQ(range.high, 505);
    const Range log = fitted_range(kLog, std::vector{0.01, 100.0});
    EXPECT_NEAR(std::log10(log.low), -2.2, 1e-12);
    EXPECT_NEAR(std::log10(log.high), 2.2, 1e-12);
}

TEST(FittedRange, StartsAtZeroNearZero) {
    EXPECT_EQ(fitted_range(kLinear, std::vector{1.0, 8.0}).low, 0);
    EXPECT_LT(fitted_range(kLinear, std::vector{-1.0, 8.0}).low, -1);
}

TEST(FittedRange, PassesOverWhatTheScaleCannotShow) {
    const Range range = fitted_range(kLog, std::vector{0.0, -3.0, 1.0, 100.0, kInf, std::nan("")});
    EXPECT_GT(range.low, 0.5);
    EXPECT_LT(range.high, 200);
}

TEST(FittedRange, DoesNotSinkUnderItsFloor) {
    Axis axis = kLog;
    axis.floor = 1e-3;
    const Range range = fitted_range(axis, std::vector{1e-12, 1.0});
    EXPECT_GT(range.low, 1e-4);
    EXPECT_LE(range.low, 1e-3);
}

TEST(FittedRange, IsNeverEmpty) {
    for (const Axis& axis : {kLinear, kLog})
        for (const auto& values :
             {std::vector<double>{}, std::vector{3.0}, std::vector{0.0}, std::vector{-2.0, -2.0},
              std::vector{kInf}, std::vector{std::nan("")}, std::vector{1e-300, 1e300}}) {
            const Range range = fitted_range(axis, values);
            EXPECT_LT(range.low, range.high) << axis.title << " of " << ::testing::PrintToString(values);
        }
}

TEST(FittedRange, KeepsGivenEnds) {
    Axis axis = kLinear;
    axis.low = 10;
    EXPECT_EQ(fitted_range(axis, std::vector{1.0, 2.0}).low, 10);
    EXPECT_GT(fitted_range(axis, std::vector{1.0, 2.0}).high, 10);
    axis.high = 20;
    EXPECT_EQ(fitted_range(axis, std::vector{1.0, 90.0}).high, 20);
}

TEST(FittedRange, RefusesEndsThatMakeNoAxis) {
    Axis axis = kLog;
    axis.low = 0;
    EXPECT_EQ(error_of([&] { fitted_range(axis, {}); }),
              "2: cannot draw the axis y: an end is 0; a logarithmic axis starts above 0");
    axis.low = 5;
    axis.high = 5;
    EXPECT_EQ(error_of([&] { fitted_range(axis, {}); }), "2: cannot draw the axis y: its ends are 5 and 5");
    axis.high = kInf;
    EXPECT_EQ(error_of([&] { fitted_range(axis, {}); }), "2: cannot draw the axis y: an end is not finite");
    EXPECT_THAT(error_of([] {
                    fitted_range(kLinear, std::vector{-1.7e308, 1.7e308});
                }),
                HasSubstr("2: cannot draw"));
}

TEST(Ticks, StepByOneTwoFive) {
    EXPECT_THAT(labels(ticks(kLinear, {0, 10}, 11)),
                ElementsAre("0", "1", "2", "3", "4", "5", "6", "7", "8", "9", "10"));
    EXPECT_THAT(labels(ticks(kLinear, {0, 10}, 6)), ElementsAre("0", "2", "4", "6", "8", "10"));
    EXPECT_THAT(labels(ticks(kLinear, {0, 10}, 4)), ElementsAre("0", "5", "10"));
    EXPECT_THAT(labels(ticks(kLinear, {-0.1, 0.31}, 6)), ElementsAre("\u22120.1", "0", "0.1", "0.2", "0.3"));
    EXPECT_THAT(labels(ticks(kLinear, {588.95, 589.25}, 4)), ElementsAre("589", "589.1", "589.2"));
}

TEST(Ticks, MinorOnesDivideTheStep) {
    EXPECT_THAT(ticks(kLinear, {0, 10}, 4).minor, ElementsAre(1, 2, 3, 4, 6, 7, 8, 9));
    EXPECT_THAT(ticks(kLinear, {0, 4}, 3).minor, ElementsAre(0.5, 1, 1.5, 2.5, 3, 3.5));
}

TEST(Ticks, DecadesOfALogarithm) {
    const Ticks few = ticks(kLog, {0.005, 20}, 8);
    EXPECT_THAT(labels(few), ElementsAre("0.01", "0.1", "1", "10"));
    EXPECT_EQ(few.minor.front(), 0.005);
    EXPECT_EQ(few.minor.size(), 5u + 8 + 8 + 8 + 1);
    EXPECT_THAT(labels(ticks(kLog, {1e-8, 1e8}, 5)), ElementsAre("10⁻⁸", "0.0001", "1", "10000", "10⁸"));
    EXPECT_THAT(labels(ticks(kLog, {0.9, 25}, 8)), ElementsAre("1", "2", "5", "10", "20"));
    EXPECT_THAT(labels(ticks(kLog, {3, 4}, 4)), ElementsAre("3", "3.5", "4"));
}

TEST(Ticks, AreInsideAscendingAndFewEnough) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> exponent(-12, 12), width(0.001, 20);
    for (int i = 0; i < 2000; ++i) {
        const bool log = i % 2;
        const double low = std::pow(10, exponent(random));
        const Range range{low, log ? low * std::pow(10, width(random)) : low * (1 + width(random))};
        const int most = 2 + i % 11;
        const Ticks out = ticks(log ? kLog : kLinear, range, most);
        EXPECT_LE(out.major.size(), static_cast<std::size_t>(most)) << range.low << ' ' << range.high;
        EXPECT_GE(out.major.size(), 1u) << range.low << ' ' << range.high << ' ' << most;
        for (std::size_t k = 0; k < out.major.size(); ++k) {
            EXPECT_GE(out.major[k].value, range.low * (1 - 1e-8));
            EXPECT_LE(out.major[k].value, range.high * (1 + 1e-8));
            if (k > 0) {
                EXPECT_LT(out.major[k - 1].value, out.major[k].value);
                EXPECT_NE(out.major[k - 1].label, out.major[k].label) << range.low << ' ' << range.high;
            }
        }
    }
}

TEST(Ticks, NameCategories) {
    const Axis axis{.categories = {"Mali-450", "VideoCore IV"}};
    EXPECT_THAT(labels(ticks(axis, fitted_range(axis, {}), 1)), ElementsAre("Mali-450", "VideoCore IV"));
}

TEST(AxisMap, IsStraightInItsScale) {
    const AxisMap linear(Scale::linear, {0, 10}, 100, 200);
    EXPECT_DOUBLE_EQ(linear(5).at, 150);
    const AxisMap log(Scale::log10, {0.01, 100}, 500, 100); // upward on a picture
    EXPECT_DOUBLE_EQ(log(0.01).at, 500);
    EXPECT_DOUBLE_EQ(log(1).at, 300);
    EXPECT_DOUBLE_EQ(log(100).at, 100);
    EXPECT_EQ(log(1).beyond, 0);
}

TEST(AxisMap, TellsWhatIsOffTheRange) {
    const AxisMap log(Scale::log10, {0.01, 100}, 500, 100);
    for (const double value : {0.0, -1.0, 0.001, -kInf}) {
        EXPECT_EQ(log(value).at, 500) << value;
        EXPECT_EQ(log(value).beyond, -1) << value;
    }
    for (const double value : {101.0, kInf}) {
        EXPECT_EQ(log(value).at, 100) << value;
        EXPECT_EQ(log(value).beyond, 1) << value;
    }
}

} // namespace
} // namespace metamer
