#include "visit/motion.h"

#include <gtest/gtest.h>
#include <set>
#include <utility>

namespace metamer {
namespace {

TEST(Fade, RunsFromOldToNewWithoutAJolt) {
    EXPECT_EQ(fade(-1), 0);
    EXPECT_EQ(fade(0), 0);
    EXPECT_EQ(fade(kFade_s / 2), 0.5);
    EXPECT_EQ(fade(kFade_s), 1);
    EXPECT_EQ(fade(1e9), 1);
    EXPECT_LT(kFade_s, 0.3) << "the issue's limit";
    for (double t = 0; t < kFade_s; t += kFade_s / 100)
        EXPECT_LE(fade(t), fade(t + kFade_s / 100)) << t;
    EXPECT_LT(fade(kFade_s / 1000), 1e-5) << "level at the start";
}

TEST(PixelShift, WalksAPixelAMinuteAndComesBack) {
    constexpr int most = 3;
    constexpr int round = 8 * most;
    std::set<std::pair<int, int>> places;
    Shift last = pixel_shift(0, most);
    EXPECT_EQ(last.x_px, 0);
    EXPECT_EQ(last.y_px, 0);
    for (int minute = 1; minute <= round; ++minute) {
        const Shift now = pixel_shift(60.0 * minute, most);
        EXPECT_EQ(std::abs(now.x_px - last.x_px) + std::abs(now.y_px - last.y_px), 1) << minute;
        EXPECT_LE(std::abs(now.x_px), most);
        EXPECT_GE(now.y_px, 0);
        EXPECT_LE(now.y_px, 2 * most);
        places.insert({now.x_px, now.y_px});
        last = now;
    }
    EXPECT_EQ(last.x_px, 0);
    EXPECT_EQ(last.y_px, 0);
    EXPECT_EQ(places.size(), static_cast<std::size_t>(round)) << "no place twice in a round";
    EXPECT_EQ(pixel_shift(59, most).x_px, 0) << "whole minutes";
}

TEST(PixelShift, StandsStillWhereNobodyWantsIt) {
    for (const double s : {0.0, 60.0, 1e7})
        EXPECT_EQ(pixel_shift(s, 0).x_px, 0) << s;
}

} // namespace
} // namespace metamer
