#include "plan/half_view.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "frames/frames.h"
#include "methods/three_numbers.h"
#include "render/draws.h"

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

TEST(HalfViews, LampsWithoutAPlaceStandWhereTheSceneWantsThem) {
    const Exhibit exhibit =
        exhibit_of("[scene]\nkind = still-life\n[lamp.1]\nspectrum = A\n[lamp.2]\nspectrum = "
                   "F11\n[lamp.3]\nspectrum = E\nposition = 1 2 3\n[lamp.4]\nspectrum = "
                   "E\ndirection = 0 -1 0\n");
    const Scene scene = build_scene(exhibit);
    const auto lamps = half_views(exhibit)[0].lamps;
    ASSERT_EQ(lamps.size(), 4u);
    const auto place = [&](std::size_t lamp) { return lamp_place(exhibit, lamps[lamp], scene); };
    EXPECT_EQ(place(0), glm::vec4(scene.lamp_directions[0], 0));
    EXPECT_EQ(place(1), glm::vec4(scene.lamp_directions[1], 0));
    EXPECT_EQ(place(2), glm::vec4(1, 2, 3, 1));
    EXPECT_EQ(place(3), glm::vec4(0, 1, 0, 0)) << "light falls down, the lamp is up";
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

TEST(ColorChunks, SayWhatThePixelsMean) {
    Display display;
    EXPECT_TRUE(color_chunks(display).srgb);
    display.working_space = find_working_space("PAL-D65");
    EXPECT_FALSE(color_chunks(display).srgb);
    EXPECT_DOUBLE_EQ(color_chunks(display).gamma, 1 / 2.2);
    display.working_space = &working_spaces()[0];
    display.matrix = rgb_from_xyz(*find_working_space("Adobe-D65"));
    EXPECT_FALSE(color_chunks(display).srgb);
    EXPECT_NEAR(color_chunks(display).xy.value()[4], 0.21, 1e-9); // green's x
    display.matrix.reset();
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

TEST(EncodedFrame, NamesItsExhibit) {
    Exhibit exhibit;
    exhibit.place = "config/some.ini";
    const Png png = decode_png(encode_frame({1, 1, {1, 2, 3, 255}}, exhibit), "frame");
    EXPECT_EQ(png.text.at("Title"), "config/some.ini");
    EXPECT_TRUE(png.color.srgb);
}

} // namespace
} // namespace metamer
