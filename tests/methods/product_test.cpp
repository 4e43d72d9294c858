#include "methods/product.h"

#include <gtest/gtest.h>

namespace metamer {
namespace {

TEST(Product, MultipliesPartByPart) {
    const LitColor<double> lamp[]{{{2, 3, 5}, {.diffuse = 0.5, .mirrored = 0}}};
    EXPECT_EQ(product<double>(lamp, {0.5, 0.25, 0.125}), (std::array<double, 3>{0.5, 0.375, 0.3125}));
}

// What a surface mirrors keeps the lamp's own color: black mirrors as well as white.
TEST(Product, MirroredLightPassesTheMaterialBy) {
    const LitColor<double> lamp[]{{{2, 3, 5}, {.diffuse = 1, .mirrored = 0.25}}};
    EXPECT_EQ(product<double>(lamp, {0, 0, 1}), (std::array<double, 3>{0.5, 0.75, 6.25}));
}

TEST(Product, LampsAddUp) {
    const LitColor<double> lamps[]{{{1, 0, 2}, {.diffuse = 0.5, .mirrored = 0}},
                                   {{4, 8, 0}, {.diffuse = 0.25, .mirrored = 0.5}}};
    EXPECT_EQ(product<double>(lamps, {1, 0.5, 0.25}), (std::array<double, 3>{3.5, 5, 0.25}));
    EXPECT_EQ(product<double>({}, {1, 1, 1}), (std::array<double, 3>{}));
}

} // namespace
} // namespace metamer
