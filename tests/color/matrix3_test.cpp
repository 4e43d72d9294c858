#include "color/matrix3.h"

#include <gtest/gtest.h>

namespace metamer {
namespace {

const Matrix3 kSome{{{{2, -1, 0.5}, {0.25, 3, -2}, {1, 0, 4}}}};

TEST(Matrix3, TimesItsInverseIsIdentity) {
    const Matrix3 product = kSome * inverse(kSome).value();
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            EXPECT_NEAR(product.m[i][j], i == j ? 1 : 0, 1e-14);
}

TEST(Matrix3, ReadsRightToLeft) {
    const Matrix3 swap{{{{0, 1, 0}, {1, 0, 0}, {0, 0, 1}}}};
    const auto v = Matrix3::diagonal(2, 3, 4) * swap * std::array<double, 3>{1, 10, 100};
    EXPECT_EQ(v, (std::array<double, 3>{20, 3, 400}));
}

TEST(Matrix3, SingularOnesHaveNoInverse) {
    EXPECT_FALSE(inverse(Matrix3{}));
    EXPECT_FALSE(inverse(Matrix3{{{{1, 2, 3}, {2, 4, 6}, {0, 0, 1}}}}));
    EXPECT_FALSE(inverse(Matrix3{{{{1, 0, 0}, {1, 1e-12, 0}, {0, 0, 1}}}}));
    // The measure is the shape, not the size: a tiny or huge diagonal is fine.
    EXPECT_TRUE(inverse(Matrix3::diagonal(1e-8, 1e-8, 1e-8)));
    EXPECT_TRUE(inverse(Matrix3::diagonal(1e8, 1, 1e-8)));
}

TEST(Matrix3, TwinsAgree) {
    const auto wide = to_linear_rgb(kSome, Xyz{0.1, 0.2, 0.3});
    const auto narrow = to_linear_rgb(kSome, BasicXyz<float>{0.1f, 0.2f, 0.3f});
    EXPECT_DOUBLE_EQ(wide.r, 2 * 0.1 - 0.2 + 0.15);
    EXPECT_NEAR(static_cast<double>(narrow.g), wide.g, 1e-7);
}

} // namespace
} // namespace metamer
