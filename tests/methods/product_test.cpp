#include "methods/product.h"

#include <gtest/gtest.h>

namespace metamer {
namespace {

using Three = std::array<double, 3>;

ProductLayers<double> of_material(const Three& material) {
    return {.material = material};
}

TEST(Product, MultipliesPartByPart) {
    const LitColor<double> lamp[]{{{2, 3, 5}, {.diffuse = 0.5, .mirrored = 0}}};
    EXPECT_EQ(product<double>(lamp, of_material({0.5, 0.25, 0.125})), (Three{0.5, 0.375, 0.3125}));
}

// What a surface mirrors keeps the lamp's own color: black mirrors as well as white.
TEST(Product, MirroredLightPassesTheMaterialBy) {
    const LitColor<double> lamp[]{{{2, 3, 5}, {.diffuse = 1, .mirrored = 0.25}}};
    EXPECT_EQ(product<double>(lamp, of_material({0, 0, 1})), (Three{0.5, 0.75, 6.25}));
}

TEST(Product, LampsAddUp) {
    const LitColor<double> lamps[]{{{1, 0, 2}, {.diffuse = 0.5, .mirrored = 0}},
                                   {{4, 8, 0}, {.diffuse = 0.25, .mirrored = 0.5}}};
    EXPECT_EQ(product<double>(lamps, of_material({1, 0.5, 0.25})), (Three{3.5, 5, 0.25}));
    EXPECT_EQ(product<double>({}, of_material({1, 1, 1})), (Three{}));
}

// Beer-Lambert by three numbers: transmittances 1/2, 1/4, 1 at thickness 1 are 1/8, 1/64, 1 at 3. Mirrored
// light does not pass the medium.
TEST(Product, AMediumIsAPowerOfEachNumber) {
    const LitColor<double> lamp[]{{{8, 64, 2}, {.diffuse = 1, .mirrored = 0.5}}};
    ProductLayers<double> layers{.material = {1, 1, 0.5}, .medium_log2 = {-1, -2, 0}, .thickness = 3};
    EXPECT_EQ(product<double>(lamp, layers), (Three{1 + 4, 1 + 32, 1 + 1}));
    layers.thickness = 0;
    EXPECT_EQ(product<double>(lamp, layers), (Three{8 + 4, 64 + 32, 1 + 1})) << "nothing of it in the way";
}

TEST(Product, LightByWayOfAnotherWallHasItsNumbersToo) {
    const LitColor<double> lamp[]{{{4, 4, 4}, {.diffuse = 0.5, .mirrored = 0, .bounced = 0.25}}};
    const ProductLayers<double> layers{.material = {1, 0.5, 0.25}, .other = {1, 0, 0.5}};
    EXPECT_EQ(product<double>(lamp, layers), (Three{3, 1, 0.625}));
}

} // namespace
} // namespace metamer
