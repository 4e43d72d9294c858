#include "atlas/levels.h"

#include <cmath>

#include <gmock/gmock.h>

namespace metamer {
namespace {

// Independent cells but for the first three, which also answer for their sum.
QuadraticForm sum_of_three(double weight_of_sum) {
    QuadraticForm form;
    for (std::size_t i = 0; i < kIntervals; ++i)
        form.g[i][i] = 1;
    RowValues sum{};
    sum[0] = sum[1] = sum[2] = 1;
    form.add_squares(weight_of_sum, {sum});
    return form;
}

double error_of(const QuadraticForm& form, const RowValues& level, const RowValues& wanted) {
    double error = 0;
    for (std::size_t i = 0; i < kIntervals; ++i)
        for (std::size_t j = 0; j < kIntervals; ++j)
            error += (level[i] - wanted[i]) * form.g[i][j] * (level[j] - wanted[j]);
    return error;
}

TEST(Levels, WithoutTiesAreRoundedHalfUpAndClamped) {
    const QuadraticForm form = sum_of_three(0);
    RowValues wanted{};
    wanted[5] = 1.4;
    wanted[6] = 1.6;
    wanted[7] = 2.5;
    wanted[8] = -3;
    wanted[9] = 260;
    const Levels found = LevelSearch(form).nearest(wanted);
    EXPECT_EQ(found.level[5], 1);
    EXPECT_EQ(found.level[6], 2);
    EXPECT_EQ(found.level[7], 3);
    EXPECT_EQ(found.level[8], 0);
    EXPECT_EQ(found.level[9], 255);
    EXPECT_NEAR(found.error, 0.16 + 0.16 + 0.25 + 9 + 25, 1e-12);
}

// 0.4 three times: rounding says 0 0 0, the sum is 1.2: one of them is 1.
TEST(Levels, KeepASumThatRoundingWouldLose) {
    const QuadraticForm form = sum_of_three(100);
    RowValues wanted{};
    wanted[0] = wanted[1] = wanted[2] = 0.4;
    const Levels found = LevelSearch(form).nearest(wanted);
    EXPECT_EQ(found.level[0] + found.level[1] + found.level[2], 1);
}

// All 4^4 levels of four cells that hang together, against the search; wanted and form by a fixed recurrence.
TEST(Levels, AreNearTheBestOfAll) {
    int best_found = 0;
    double excess = 0;
    for (int run = 0; run < 50; ++run) {
        auto random = [state = run * 7919 + 13]() mutable {
            state = (state * 1103 + 12345) % 65536;
            return state / 65536.0;
        };
        QuadraticForm form = sum_of_three(0);
        for (int n = 0; n < 6; ++n) {
            std::array<RowValues, 3> functions{};
            for (RowValues& function : functions)
                for (std::size_t i = 0; i < 4; ++i)
                    function[i] = random();
            form.add_squares(5, functions);
        }
        RowValues wanted{};
        for (std::size_t i = 0; i < 4; ++i)
            wanted[i] = 1 + random();
        double least = 1e300;
        for (int code = 0; code < 256; ++code) {
            RowValues level{};
            for (std::size_t i = 0; i < 4; ++i)
                level[i] = (code >> (2 * i)) % 4;
            least = std::min(least, error_of(form, level, wanted));
        }
        const double found = LevelSearch(form).nearest(wanted).error;
        EXPECT_GE(found, least - 1e-9);
        best_found += found < least + 1e-9;
        excess += found / least - 1;
    }
    EXPECT_GE(best_found, 45);
    EXPECT_LE(excess / 50, 0.05);
}

TEST(Levels, TheFixedOneIs255AndTheOthersMakeUpForIt) {
    const QuadraticForm form = sum_of_three(100);
    RowValues wanted{};
    wanted[0] = 100;
    wanted[1] = 252.0;
    wanted[2] = 50;
    const Levels found = LevelSearch(form).nearest(wanted, 1);
    EXPECT_EQ(found.level[1], 255);
    EXPECT_NEAR(found.level[0] + found.level[2], 147, 1.01);
}

TEST(LeastWithin, SolvesWhatTheBoundsAllow) {
    QuadraticForm form = sum_of_three(2);
    RowValues start{}, h{};
    const RowValues wanted = [] {
        RowValues v{};
        v[0] = 0.25;
        v[1] = 0.5;
        v[2] = 0.125;
        v[3] = 1.5;
        v[4] = -1;
        return v;
    }();
    h = form.times(wanted);
    const RowValues found = least_within(form, h, start, 0, 1);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(found[i], wanted[i], 1e-5) << i;
    EXPECT_EQ(found[3], 1);
    EXPECT_EQ(found[4], 0);
}

TEST(QuadraticForm, PullsByAShareOfTheDiagonal) {
    QuadraticForm form;
    form.g[0][0] = 64;
    const RowValues pull = form.add_pull(0.5, 0.25);
    EXPECT_DOUBLE_EQ(pull[0], 0.5 * (64 + 0.25));
    EXPECT_DOUBLE_EQ(pull[1], 0.5 * 0.25);
    EXPECT_DOUBLE_EQ(form.g[0][0], 64 + pull[0]);
    EXPECT_EQ(form.g[0][1], 0);
}

} // namespace
} // namespace metamer
