#include "report/statistics.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "image/error_of.h"

namespace metamer {
namespace {

TEST(Quantile, LiesBetweenTheTwoAroundItsPlace) {
    const std::vector<double> values{10, 20, 30, 40};
    EXPECT_EQ(quantile(values, 0), 10);
    EXPECT_EQ(quantile(values, 1), 40);
    EXPECT_DOUBLE_EQ(quantile(values, 0.5), 25);
    EXPECT_DOUBLE_EQ(quantile(values, 0.25), 17.5); // place 0.75
}

// 0..100: by the definition the p-quantile is 100 p.
TEST(Summarize, EvenStepsInAnyOrder) {
    std::vector<double> values;
    for (int i = 0; i <= 100; ++i)
        values.push_back((i * 37) % 101);
    const Summary s = summarize(values, "steps");
    EXPECT_EQ(s.count, 101u);
    EXPECT_NEAR(s.mean, 50, 1e-12); // 101 roundings of at most 50 * 2^-53
    EXPECT_DOUBLE_EQ(s.q1, 25);
    EXPECT_DOUBLE_EQ(s.median, 50);
    EXPECT_DOUBLE_EQ(s.q3, 75);
    EXPECT_DOUBLE_EQ(s.p95, 95);
    EXPECT_EQ(s.max, 100);
}

TEST(Summarize, OneValueIsAllOfThem) {
    const Summary s = summarize(std::vector{7.5}, "one");
    for (const double value : {s.mean, s.q1, s.median, s.q3, s.p95, s.max})
        EXPECT_EQ(value, 7.5);
}

TEST(Summarize, MeanOfGreatNumbersDoesNotOverflow) {
    EXPECT_DOUBLE_EQ(summarize(std::vector{1.5e308, 1.5e308}, "great").mean, 1.5e308);
}

TEST(Summarize, RefusesWhatHasNoSummary) {
    EXPECT_EQ(error_of([] { summarize({}, "ms of rgb"); }),
              "2: cannot summarize ms of rgb: there are no values");
    EXPECT_EQ(error_of([] {
                  summarize(std::vector{1.0, std::nan("")}, "ms of rgb");
              }),
              "2: cannot summarize ms of rgb: a value is nan");
}

} // namespace
} // namespace metamer
