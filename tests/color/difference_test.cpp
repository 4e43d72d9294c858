#include "color/difference.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace metamer {
namespace {

// Sharma, Wu, Dalal 2005, table 1: all 34 pairs, which cover every branch of the hue.
struct Pair {
    Lab a, b;
    double difference;
};
constexpr Pair kSharma[] = {
    {{50, 2.6772, -79.7751}, {50, 0, -82.7485}, 2.0425},
    {{50, 3.1571, -77.2803}, {50, 0, -82.7485}, 2.8615},
    {{50, 2.8361, -74.0200}, {50, 0, -82.7485}, 3.4412},
    {{50, -1.3802, -84.2814}, {50, 0, -82.7485}, 1.0000},
    {{50, -1.1848, -84.8006}, {50, 0, -82.7485}, 1.0000},
    {{50, -0.9009, -85.5211}, {50, 0, -82.7485}, 1.0000},
    {{50, 0, 0}, {50, -1, 2}, 2.3669},
    {{50, -1, 2}, {50, 0, 0}, 2.3669},
    {{50, 2.4900, -0.0010}, {50, -2.4900, 0.0009}, 7.1792},
    {{50, 2.4900, -0.0010}, {50, -2.4900, 0.0010}, 7.1792},
    {{50, 2.4900, -0.0010}, {50, -2.4900, 0.0011}, 7.2195},
    {{50, 2.4900, -0.0010}, {50, -2.4900, 0.0012}, 7.2195},
    {{50, -0.0010, 2.4900}, {50, 0.0009, -2.4900}, 4.8045},
    {{50, -0.0010, 2.4900}, {50, 0.0010, -2.4900}, 4.8045},
    {{50, -0.0010, 2.4900}, {50, 0.0011, -2.4900}, 4.7461},
    {{50, 2.5, 0}, {50, 0, -2.5}, 4.3065},
    {{50, 2.5, 0}, {73, 25, -18}, 27.1492},
    {{50, 2.5, 0}, {61, -5, 29}, 22.8977},
    {{50, 2.5, 0}, {56, -27, -3}, 31.9030},
    {{50, 2.5, 0}, {58, 24, 15}, 19.4535},
    {{50, 2.5, 0}, {50, 3.1736, 0.5854}, 1.0000},
    {{50, 2.5, 0}, {50, 3.2972, 0}, 1.0000},
    {{50, 2.5, 0}, {50, 1.8634, 0.5757}, 1.0000},
    {{50, 2.5, 0}, {50, 3.2592, 0.3350}, 1.0000},
    {{60.2574, -34.0099, 36.2677}, {60.4626, -34.1751, 39.4387}, 1.2644},
    {{63.0109, -31.0961, -5.8663}, {62.8187, -29.7946, -4.0864}, 1.2630},
    {{61.2901, 3.7196, -5.3901}, {61.4292, 2.2480, -4.9620}, 1.8731},
    {{35.0831, -44.1164, 3.7933}, {35.0232, -40.0716, 1.5901}, 1.8645},
    {{22.7233, 20.0904, -46.6940}, {23.0331, 14.9730, -42.5619}, 2.0373},
    {{36.4612, 47.8580, 18.3852}, {36.2715, 50.5065, 21.2231}, 1.4146},
    {{90.8027, -2.0831, 1.4410}, {91.1528, -1.6435, 0.0447}, 1.4441},
    {{90.9257, -0.5406, -0.9208}, {88.6381, -0.8985, -0.7239}, 1.5381},
    {{6.7747, -0.2908, -2.4247}, {5.8714, -0.0985, -2.2286}, 0.6377},
    {{2.0776, 0.0795, -1.1350}, {0.9033, -0.0636, -0.5514}, 0.9082},
};

TEST(Ciede2000, IsThePublishedTable) {
    for (const Pair& pair : kSharma) {
        EXPECT_NEAR(delta_e_2000(pair.a, pair.b), pair.difference, 5e-5)
            << pair.a.l << ' ' << pair.a.a << ' ' << pair.b.a;
        EXPECT_NEAR(delta_e_2000(pair.b, pair.a), pair.difference, 5e-5) << "the other way round";
    }
}

TEST(Cielab, WhiteIs100AndBlackIs0) {
    const Xyz white = display_white();
    const Lab w = lab(white, white), k = lab({0, 0, 0}, white);
    EXPECT_NEAR(w.l, 100, 1e-12);
    EXPECT_NEAR(w.a, 0, 1e-12);
    EXPECT_NEAR(w.b, 0, 1e-12);
    EXPECT_NEAR(k.l, 0, 1e-12);
}

// Both branches of CIELAB's f meet at t = (6/29)^3 with the same slope.
TEST(Cielab, IsSmoothWhereItsBranchesMeet) {
    const double t = 216.0 / 24389, d = 1e-9;
    const auto l = [](double y) { return lab({y, y, y}, {1, 1, 1}).l; };
    EXPECT_NEAR(l(t - d), l(t + d), 1e-5);
    EXPECT_NEAR((l(t) - l(t - 1e-6)) / (l(t + 1e-6) - l(t)), 1, 1e-3);
}

TEST(Cielab, MiddleGrayIsKnown) {
    EXPECT_NEAR(lab({0.184187 * 0.95047, 0.184187, 0.184187 * 1.08883}, {0.95047, 1, 1.08883}).l, 50, 1e-3);
}

TEST(DisplayWhite, IsD65) {
    EXPECT_NEAR(display_white().x, 0.95046, 1e-5);
    EXPECT_NEAR(display_white().z, 1.08906, 1e-5);
}

// The oracle is delta_e_2000 itself: over light, dark, saturated colors and the blue where R_T turns the
// ellipses, in several directions.
TEST(DeltaE2000, SlopesAreItsLimit) {
    const Xyz white = display_white();
    const std::vector<Xyz> colors{{0.3, 0.4, 0.2},     {0.9, 0.95, 1.0},    {0.006, 0.005, 0.004},
                                  {0.18, 0.08, 0.9},   {0.2, 0.11, 0.55},   {0.6, 0.4, 0.001},
                                  {1.3, 1.0, 0.1},     0.2 * white,         {0.02, 0.06, 0.03},
                                  {0.162, 0.15, 0.19}, {0.05, 0.0321, 0.09}};
    for (const Xyz& c : colors)
        for (const auto& d : {std::array{1.0, 0.0, 0.0},
                              {0.0, 1.0, 0.0},
                              {0.0, 0.0, 1.0},
                              {1.0, 1.0, 1.0},
                              {0.5, -0.3, 0.8},
                              {-0.6, 0.4, 0.2}}) {
            const double small = 1e-6 * c.y;
            const auto seen = delta_e_2000_slopes(c) * std::array{small * d[0], small * d[1], small * d[2]};
            const double linear = std::hypot(seen[0], seen[1], seen[2]);
            const double exact = delta_e_2000(c, c + small * Xyz{d[0], d[1], d[2]});
            EXPECT_NEAR(linear / exact, 1, 1e-3) << c.x << " " << c.y << " " << c.z << " d " << d[0] << d[1];
        }
}

TEST(DeltaE2000, SlopesOfBlackAreFinite) {
    for (const auto& row : delta_e_2000_slopes({}).m)
        for (const double slope : row)
            EXPECT_TRUE(std::isfinite(slope));
}

} // namespace
} // namespace metamer
