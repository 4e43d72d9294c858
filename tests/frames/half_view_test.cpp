#include "render/half_view.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "frames/frames.h"
#include "methods/three_numbers.h"

namespace metamer {
namespace {

TEST(MethodOf, TheObjectsOwnBeatsTheHalfsBeatsTheExhibits) {
    Exhibit exhibit;
    exhibit.method = Method::rgb;
    Half half;
    ObjectSetting object;
    EXPECT_EQ(method_of(exhibit, nullptr, object), Method::rgb);
    EXPECT_EQ(method_of(exhibit, &half, object), Method::rgb);
    half.method = Method::tristimulus;
    EXPECT_EQ(method_of(exhibit, &half, object), Method::tristimulus);
    object.method = Method::spectral;
    EXPECT_EQ(method_of(exhibit, &half, object), Method::spectral);
}

Exhibit patches(const std::string& rest) {
    return exhibit_of("[scene]\nkind = patches\nmaterials = cc-red\n" + rest);
}

std::vector<HalfView> views_of(const Exhibit& exhibit) {
    return half_views(exhibit, build_scene(exhibit));
}

TEST(HalfViews, WithoutComparisonThereIsOne) {
    const Exhibit exhibit = patches("");
    const auto views = views_of(exhibit);
    ASSERT_EQ(views.size(), 1u);
    EXPECT_EQ(views[0].half, nullptr);
}

TEST(HalfViews, ShadowCastersComeFirst) {
    const Exhibit exhibit = exhibit_of(
        "[scene]\nkind = still-life\n[lamp.1]\nspectrum = A\n[lamp.2]\nspectrum = F11\nshadow = yes\n");
    const auto views = views_of(exhibit);
    EXPECT_EQ(views[0].shadows, 1);
    EXPECT_TRUE(views[0].lamps[0].shadow);
    EXPECT_EQ(views[0].lamps[0].key, exhibit.lamps[1].key);
}

TEST(HalfViews, BradfordTurnsTheLampWhite) {
    const Exhibit exhibit = patches("[display]\nadaptation = bradford\n[lamp.1]\nspectrum = A2800\n");
    const HalfView view = views_of(exhibit)[0];
    const auto white = to_linear_rgb(view.output.adapted_rgb_from_xyz(),
                                     lamp_xyz(view.lamps[0].emission, observer(exhibit.atlas)));
    EXPECT_NEAR(white.r, 1, 1e-6);
    EXPECT_NEAR(white.g, 1, 1e-6);
    EXPECT_NEAR(white.b, 1, 1e-6);
}

TEST(HalfViews, BradfordCannotAdaptToSodium) {
    const Exhibit exhibit = patches("[display]\nadaptation = bradford\n[lamp.1]\nspectrum = line:589.3\n");
    EXPECT_THROW(views_of(exhibit), Error);
}

TEST(HalfViews, AHalfsWorkingSpaceBeatsAnOwnMatrix) {
    const Exhibit exhibit =
        patches("[display]\nmatrix = 1 0 0 0 1 0 0 0 1\n[compare]\nright.working_space = NTSC-C\n");
    const auto views = views_of(exhibit);
    EXPECT_EQ(views[0].output.rgb_from_xyz.m, Matrix3::identity().m);
    EXPECT_EQ(views[1].output.rgb_from_xyz.m, rgb_from_xyz(*find_working_space("NTSC-C")).m);
}

TEST(ColorChunks, SayWhatThePixelsMean) {
    Display display;
    EXPECT_TRUE(color_chunks(display).srgb);
    display.transfer = Transfer::none;
    EXPECT_FALSE(color_chunks(display).srgb);
    EXPECT_EQ(color_chunks(display).gamma, 1);
    display.working_space = find_working_space("NTSC-C");
    const auto xy = color_chunks(display).xy.value();
    EXPECT_NEAR(xy[0], 0.31006, 1e-9);    // white
    EXPECT_NEAR(xy[5], 0.71, 1e-9);       // green's y
    display.matrix = Matrix3::identity(); // primaries X, Y, Z: y of X is 0, no chromaticities for a PNG
    EXPECT_FALSE(color_chunks(display).xy);
}

} // namespace
} // namespace metamer
