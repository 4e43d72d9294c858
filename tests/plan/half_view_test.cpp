#include "plan/half_view.h"

#include <gtest/gtest.h>

#include "exhibit/support.h"
#include "methods/three_numbers.h"

namespace metamer {
namespace {

TEST(ChoiceOf, TheObjectsOwnBeatsTheHalfsBeatsTheExhibits) {
    Exhibit exhibit;
    Half half;
    ObjectSetting object;
    EXPECT_EQ(choice_of(exhibit, &half, object), std::nullopt) << "the planner's";
    exhibit.accuracy.method = Method::rgb;
    EXPECT_EQ(choice_of(exhibit, nullptr, object), Method::rgb);
    EXPECT_EQ(choice_of(exhibit, &half, object), Method::rgb);
    half.method = MethodChoice(Method::tristimulus);
    EXPECT_EQ(choice_of(exhibit, &half, object), Method::tristimulus);
    half.method = MethodChoice();
    EXPECT_EQ(choice_of(exhibit, &half, object), std::nullopt) << "auto, asked for";
    object.method = MethodChoice(Method::spectral);
    EXPECT_EQ(choice_of(exhibit, &half, object), Method::spectral);
    object.method = MethodChoice();
    half.method = MethodChoice(Method::rgb);
    EXPECT_EQ(choice_of(exhibit, &half, object), std::nullopt) << "auto, asked for";
}

Exhibit patches(const std::string& rest) {
    return exhibit_of("[scene]\nkind = patches\nmaterials = cc-red\n" + rest);
}

std::vector<HalfView> views_of(const Exhibit& exhibit) {
    return half_views(exhibit);
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

TEST(HalfViews, BradfordTurnsTheLightOfAllLampsWhite) {
    const Exhibit exhibit =
        patches("[display]\nadaptation = bradford\n[lamp.1]\nspectrum = A2800\nstrength = "
                "3\n[lamp.2]\nspectrum = F7\nstrength = 0.5\n");
    const HalfView view = views_of(exhibit)[0];
    Xyz light;
    for (const HalfLamp& lamp : view.lamps)
        light = light + lamp.strength * lamp_xyz(lamp.emission, observer(exhibit.atlas));
    const auto white = to_linear_rgb(view.output.adapted_rgb_from_xyz(), (1 / 3.5) * light);
    EXPECT_NEAR(white.r, 1, 1e-6);
    EXPECT_NEAR(white.g, 1, 1e-6);
    EXPECT_NEAR(white.b, 1, 1e-6);
}

TEST(HalfViews, WithoutAdaptationThereIsNone) {
    EXPECT_EQ(views_of(patches("[lamp.1]\nspectrum = A2800\n"))[0].output.adaptation.m,
              Matrix3::identity().m);
}

TEST(HalfViews, TheTransferIsTheDisplays) {
    EXPECT_EQ(views_of(patches(""))[0].output.transfer, Transfer::srgb);
    EXPECT_EQ(views_of(patches("[display]\ntransfer = none\n"))[0].output.transfer, Transfer::none);
}

TEST(HalfViews, FlatScenesHaveNoShadows) {
    const HalfView view = views_of(patches("[lamp.1]\nspectrum = A\nshadow = yes\n"))[0];
    EXPECT_EQ(view.shadows, 0);
    EXPECT_FALSE(view.lamps[0].shadow);
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
    EXPECT_EQ(views[1].output.white, &white_emission(*find_working_space("NTSC-C")));
}

// An own matrix says nothing of an illuminant: materials of method rgb are known under D65 then.
TEST(HalfViews, AnOwnMatrixHasTheWhiteOfSrgb) {
    Exhibit exhibit = patches("[display]\nworking_space = NTSC-C\n");
    exhibit.display.matrix = Matrix3::identity();
    EXPECT_EQ(views_of(exhibit)[0].output.white, &white_emission(working_spaces()[0]));
}

} // namespace
} // namespace metamer
