#include "plan/cost.h"

#include <gtest/gtest.h>

namespace metamer {
namespace {

double cost(Method method, int taps = 0, Surface surface = Surface::plain, int lamps = 1) {
    return cost_ratio({.method = method, .taps = taps, .surface = surface, .lamps = lamps});
}

// What `rgb` costs with pow(), as everybody writes it, is 1; without pow() it is less.
TEST(Cost, ConstantsAreCheapestAndTheThesissLoopIsDearest) {
    EXPECT_LT(cost(Method::folded), 1);
    EXPECT_LE(cost(Method::folded), cost(Method::rgb));
    EXPECT_LT(cost(Method::rgb), 1);
    EXPECT_LT(cost(Method::rgb), cost(Method::tristimulus)) << "the matrix";
    EXPECT_EQ(cost(Method::prefiltered), cost(Method::tristimulus));
    EXPECT_LT(cost(Method::tristimulus), cost(Method::reduced, 8));
    EXPECT_LT(cost(Method::reduced, 32), cost(Method::packed));
    EXPECT_LT(1.5 * cost(Method::packed), cost(Method::spectral));
}

TEST(Cost, GrowsWithTapsAndLamps) {
    for (std::size_t i = 1; i < kTapCounts.size(); ++i)
        EXPECT_LT(cost(Method::reduced, kTapCounts[i - 1]), cost(Method::reduced, kTapCounts[i]));
    for (const MethodInfo& info : kMethods) {
        const PixelWork one{.method = info.method, .taps = 8};
        PixelWork two = one;
        two.lamps = 2;
        EXPECT_LT(operations(one), operations(two)) << info.name;
    }
}

TEST(Cost, EachSurfaceCostsMoreThanNone) {
    for (const MethodInfo& info : kMethods)
        for (const Surface surface : {Surface::maps, Surface::ramp, Surface::medium, Surface::bounce}) {
            if (info.method == Method::folded && surface == Surface::medium)
                continue; // it cannot
            const PixelWork plain{.method = info.method, .taps = 8};
            PixelWork work = plain;
            work.surface = surface;
            EXPECT_LE(operations(plain), operations(work)) << info.name << static_cast<int>(surface);
        }
}

} // namespace
} // namespace metamer
