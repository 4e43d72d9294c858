#include "color/gamut.h"

#include <gtest/gtest.h>
#include <random>

#include "base/float16.h"

namespace metamer {
namespace {

// Round-off of a component: a few units in the last place of 1, more where it is a difference.
template <class T>
constexpr double kRounding = 0;
template <>
constexpr double kRounding<double> = 1e-14;
template <>
constexpr double kRounding<float> = 1e-6;
template <>
constexpr double kRounding<Float16> = 4e-3;

// gcc 12 has no typeid of _Float16, which a typed test of it would need.
template <class T>
struct Of {
    using Scalar = T;
};

template <class Type>
class KeptHue : public testing::Test {
protected:
    using T = typename Type::Scalar;
    using Rgb = BasicLinearRgb<T>;

    /// Half of them outside the space.
    Rgb random_color() {
        std::uniform_real_distribution<double> uniform(-0.5, 2);
        return {static_cast<T>(uniform(rng_)), static_cast<T>(uniform(rng_)), static_cast<T>(uniform(rng_))};
    }
    static LinearRgb wide(const Rgb& c) {
        return {static_cast<double>(c.r), static_cast<double>(c.g), static_cast<double>(c.b)};
    }
    static LinearRgb kept(double r, double g, double b) {
        return wide(kept_hue<T>({static_cast<T>(r), static_cast<T>(g), static_cast<T>(b)}));
    }
    static void expect_near(const LinearRgb& a, const LinearRgb& b) {
        EXPECT_NEAR(a.r, b.r, kRounding<T>);
        EXPECT_NEAR(a.g, b.g, kRounding<T>);
        EXPECT_NEAR(a.b, b.b, kRounding<T>);
    }

private:
    std::mt19937 rng_{1931}; // NOLINT: the same on every run
};
using Scalars = testing::Types<Of<double>, Of<float>, Of<Float16>>;
TYPED_TEST_SUITE(KeptHue, Scalars);

TYPED_TEST(KeptHue, LeavesColorsOfTheSpaceAlone) {
    for (const double r : {0.0, 0.25, 1.0})
        for (const double g : {0.0, 0.5, 1.0})
            for (const double b : {0.0, 0.75, 1.0})
                this->expect_near(this->kept(r, g, b), {r, g, b});
}

// Gray of (-0.5, 1, 1) is 1/2; half the way to it, the least is 0 and the others 3/4.
TYPED_TEST(KeptHue, MixesNegativeComponentsUpToZero) {
    this->expect_near(this->kept(-0.5, 1, 1), {0, 0.75, 0.75});
}

TYPED_TEST(KeptHue, ScalesWhatIsAboveOneDownTogether) {
    this->expect_near(this->kept(4, 2, 1), {1, 0.5, 0.25});
}

// Both: gray 1, mixed (0, 1.5, 1.5), then down to white's height.
TYPED_TEST(KeptHue, DoesBothInTurn) {
    this->expect_near(this->kept(-1, 2, 2), {0, 1, 1});
}

TYPED_TEST(KeptHue, BlackAndLightThatIsNoneAreBlack) {
    this->expect_near(this->kept(0, 0, 0), {0, 0, 0});
    this->expect_near(this->kept(-1, 0.5, 0.25), {0, 0, 0});
    this->expect_near(this->kept(-1, -2, -3), {0, 0, 0});
}

TYPED_TEST(KeptHue, NothingIsLeftOutsideTheSpaceAndTheOrderStays) {
    for (int i = 0; i < 2000; ++i) {
        const auto c = this->random_color();
        const LinearRgb in = this->wide(c), out = this->wide(kept_hue(c));
        for (const double v : {out.r, out.g, out.b}) {
            EXPECT_GE(v, -kRounding<typename TypeParam::Scalar>);
            EXPECT_LE(v, 1 + kRounding<typename TypeParam::Scalar>);
        }
        EXPECT_LE(std::min((in.r - in.g) * (out.r - out.g), (in.g - in.b) * (out.g - out.b)) < 0 ? 1 : 0, 0)
            << in.r << ' ' << in.g << ' ' << in.b;
    }
}

// Hue as the differences of the components: they keep their ratio.
TYPED_TEST(KeptHue, DifferencesKeepTheirRatio) {
    int moved = 0;
    for (int i = 0; i < 2000; ++i) {
        const auto c = this->random_color();
        const LinearRgb in = this->wide(c), out = this->wide(kept_hue(c));
        moved += std::abs(in.r - out.r) > 0.01;
        EXPECT_NEAR((in.r - in.g) * (out.g - out.b), (in.g - in.b) * (out.r - out.g),
                    4 * kRounding<typename TypeParam::Scalar>);
    }
    EXPECT_GT(moved, 500);
}

TEST(InGamut, IsAboutNegativeComponentsOnly) {
    EXPECT_TRUE(in_gamut({0, 0, 0}));
    EXPECT_TRUE(in_gamut({5, 0.5, 0}));
    EXPECT_FALSE(in_gamut({1, -0.01, 0}));
    EXPECT_TRUE(in_gamut({1, -0.01, 0}, 0.02));
}

} // namespace
} // namespace metamer
