#include "exhibit/load.h"

#include <gmock/gmock.h>

#include "base/files.h"
#include "exhibit/support.h"

namespace metamer {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(Load, AnEmptyFileIsTheDefaultOfEveryKey) {
    std::vector<std::string> warnings;
    const Exhibit exhibit = exhibit_of("", {}, &warnings);
    EXPECT_EQ(exhibit.place, "k.ini");
    EXPECT_EQ(exhibit.display.width_px, 1280);
    EXPECT_EQ(exhibit.display.height_px, 720);
    EXPECT_EQ(exhibit.display.working_space->name, "sRGB-D65");
    EXPECT_FALSE(exhibit.display.matrix);
    EXPECT_EQ(exhibit.display.transfer, Transfer::srgb);
    EXPECT_EQ(exhibit.display.adaptation, Adaptation::none);
    EXPECT_EQ(exhibit.display.supersample, 1);
    EXPECT_EQ(exhibit.display.gamut, Gamut::clip);
    EXPECT_EQ(exhibit.display.color_depth_bits, 24);
    EXPECT_FALSE(exhibit.display.dither);
    EXPECT_FALSE(exhibit.accuracy.method) << "auto";
    EXPECT_EQ(exhibit.accuracy.tolerance, 0.5);
    EXPECT_EQ(exhibit.accuracy.taps, 8);
    EXPECT_EQ(exhibit.scene, SceneKind::crayons);
    EXPECT_EQ(exhibit.objects.size(), 15u);
    ASSERT_EQ(exhibit.lamps.size(), 1u);
    EXPECT_EQ(exhibit.lamps[0].lamp.name, "D65");
    EXPECT_EQ(exhibit.lamps[0].strength, 1);
    EXPECT_FALSE(exhibit.lamps[0].position || exhibit.lamps[0].direction || exhibit.lamps[0].shadow);
    EXPECT_FALSE(exhibit.compare);
    EXPECT_THAT(warnings, IsEmpty());
}

TEST(Load, Display) {
    const Display d =
        exhibit_of("[display]\nwidth = 640\nheight=480\nworking_space = cie rgb (E)\ntransfer = None\n"
                   "adaptation = bradford\nsupersample = 2\n")
            .display;
    EXPECT_EQ(d.width_px, 640);
    EXPECT_EQ(d.height_px, 480);
    EXPECT_EQ(d.working_space->name, "CIE-RGB-E");
    EXPECT_EQ(d.transfer, Transfer::none);
    EXPECT_EQ(d.adaptation, Adaptation::bradford);
    EXPECT_EQ(d.supersample, 2);
}

TEST(Load, GamutDepthAndDithering) {
    const Display d = exhibit_of("[display]\ngamut = Keep-Hue\ncolor_depth = 16\ndither = yes\n").display;
    EXPECT_EQ(d.gamut, Gamut::keep_hue);
    EXPECT_EQ(d.color_depth_bits, 16);
    EXPECT_TRUE(d.dither);
    EXPECT_EQ(exhibit_of("[display]\ngamut = clip\ncolor_depth = 24\n").display.color_depth_bits, 24);
}

TEST(Load, AutoIsAMethodToo) {
    const Exhibit exhibit = exhibit_of(
        "[accuracy]\nmethod = packed\ntolerance = 0.25\ntaps = 12\n[object.crayon-1]\nmethod = auto\n"
        "[compare]\nleft.method = Auto\n");
    EXPECT_EQ(exhibit.accuracy.method, MethodChoice(Method::packed));
    EXPECT_EQ(exhibit.accuracy.tolerance, 0.25);
    EXPECT_EQ(exhibit.accuracy.taps, 12);
    ASSERT_TRUE(exhibit.objects.at(0).method) << "auto was asked for";
    EXPECT_FALSE(*exhibit.objects.at(0).method);
    EXPECT_FALSE(exhibit.objects.at(1).method) << "nothing was asked for";
    ASSERT_TRUE(exhibit.compare->left.method);
    EXPECT_FALSE(*exhibit.compare->left.method);
    EXPECT_FALSE(exhibit.compare->right.method);
    for (const MethodInfo& info : kMethods)
        EXPECT_EQ(exhibit_of("", {"accuracy.method=" + std::string(info.name)}).accuracy.method,
                  MethodChoice(info.method));
}

TEST(Load, MediaHaveGlassALiquidAndTheirThickness) {
    const Exhibit plain = exhibit_of("[scene]\nkind = media\n");
    ASSERT_EQ(plain.objects.size(), 3u);
    EXPECT_FALSE(plain.objects[0].medium) << "the light box";
    EXPECT_EQ(plain.objects[1].medium->material.name, "glass-cobalt");
    EXPECT_EQ(plain.objects[1].thickness, 4);
    EXPECT_EQ(plain.objects[2].medium->material.name, "liquid-allura-red");
    const Exhibit own = exhibit_of("[scene]\nkind = media\n[object.wedge]\nmedium = liquid-copper\n"
                                   "thickness = 2.5\n[object.vessel]\nthickness = 0\n");
    EXPECT_EQ(own.objects[1].medium->material.name, "liquid-copper");
    EXPECT_EQ(own.atlas.materials.at(static_cast<std::size_t>(own.objects[1].medium->key)).name,
              "liquid-copper");
    EXPECT_EQ(own.objects[1].thickness, 2.5);
    EXPECT_EQ(own.objects[2].thickness, 0);
    EXPECT_EQ(own.objects[2].medium->material.name, "liquid-allura-red");
}

TEST(Load, ACornerIsAWallAndAFloor) {
    const Exhibit exhibit = exhibit_of("[scene]\nkind = corner\nmaterials = cc-red, cc-white\n");
    ASSERT_EQ(exhibit.objects.size(), 2u);
    EXPECT_EQ(exhibit.objects[0].name, "wall");
    EXPECT_EQ(exhibit.objects[0].material.material.name, "cc-red");
    EXPECT_EQ(exhibit.objects[1].name, "floor");
    EXPECT_EQ(exhibit.objects[1].material.material.name, "cc-white");
}

TEST(Load, AMatrixIsWrittenRowByRow) {
    const Display d = exhibit_of("[display]\nmatrix = 1 2 3, 0 1 4  5,6 ,0\n").display;
    ASSERT_TRUE(d.matrix);
    EXPECT_THAT(d.matrix->m[0], ElementsAre(1, 2, 3));
    EXPECT_THAT(d.matrix->m[1], ElementsAre(0, 1, 4));
    EXPECT_THAT(d.matrix->m[2], ElementsAre(5, 6, 0));
}

TEST(Load, Lamps) {
    const Exhibit exhibit = exhibit_of("[lamp.2]\nspectrum = f2\nposition = 1 2 3\nfalloff = 1 0.5 0.25\n"
                                       "shadow = yes\nstrength = 0.5\n[lamp.1]\nspectrum = planck:3000\n"
                                       "direction = 4, 0, -3\n[lamp.3]\n");
    ASSERT_EQ(exhibit.lamps.size(), 3u);
    EXPECT_EQ(exhibit.lamps[0].lamp.name, "planck:3000");
    EXPECT_THAT(*exhibit.lamps[0].direction, ElementsAre(0.8, 0, -0.6));
    EXPECT_FALSE(exhibit.lamps[0].position);
    EXPECT_EQ(exhibit.lamps[1].lamp.name, "F2");
    EXPECT_THAT(*exhibit.lamps[1].position, ElementsAre(1, 2, 3));
    EXPECT_FALSE(exhibit.lamps[1].direction);
    EXPECT_EQ(exhibit.lamps[1].falloff.constant, 1);
    EXPECT_EQ(exhibit.lamps[1].falloff.linear, 0.5);
    EXPECT_EQ(exhibit.lamps[1].falloff.quadratic, 0.25);
    EXPECT_TRUE(exhibit.lamps[1].shadow);
    EXPECT_EQ(exhibit.lamps[1].strength, 0.5);
    EXPECT_EQ(exhibit.lamps[2].lamp.name, "D65");
    EXPECT_EQ(exhibit.lamps[2].falloff.constant, 1);
}

TEST(Load, Objects) {
    const Exhibit exhibit =
        exhibit_of("[scene]\nkind = still-life\n[object.orange]\nmaterial = cc-red\nmethod = rgb\n"
                   "bump = maps/orange-peel.png\nbump_height = 0.3\nspecular = 0.75\n"
                   "shininess = 99\n[object.cloth]\nluminance_map = maps/weave.png\n"
                   "[object.ball]\nbump = maps/weave.png\n");
    const ObjectSetting& orange = exhibit.objects.at(3);
    EXPECT_EQ(orange.name, "orange");
    EXPECT_EQ(orange.material.material.name, "cc-red");
    EXPECT_EQ(exhibit.atlas.materials.at(static_cast<std::size_t>(orange.material.key)).name, "cc-red");
    EXPECT_EQ(orange.method, MethodChoice(Method::rgb));
    EXPECT_EQ(orange.bump_map->width, 256);
    EXPECT_EQ(orange.bump_map->height, 128);
    EXPECT_EQ(orange.bump, 0.3);
    EXPECT_EQ(orange.specular, 0.75);
    EXPECT_EQ(orange.shininess, 99);
    EXPECT_EQ(exhibit.objects.at(9).luminance_map->width, 256);
    EXPECT_EQ(exhibit.objects.at(2).bump, 0.02);
    EXPECT_EQ(exhibit.objects.at(0).bump, 0);
}

TEST(Load, APieceIsReachedByItsMaterialToo) {
    const Exhibit exhibit =
        exhibit_of("[object.crayon-red]\nspecular = 0.5\n[object.crayon-1]\nspecular = 0.25\n");
    EXPECT_EQ(exhibit.objects.at(0).specular, 0.25);
    EXPECT_EQ(exhibit.objects.at(4).material.material.name, "crayon-red");
    EXPECT_EQ(exhibit.objects.at(4).specular, 0.5);
}

TEST(Load, RampEndsAndMixes) {
    const Exhibit exhibit =
        exhibit_of("[scene]\nkind = ramp\nmaterials = cc-red, cc-blue\n[object.ramp-rgb]\n"
                   "method = spectral\n");
    for (const ObjectSetting& ramp : exhibit.objects) {
        EXPECT_EQ(ramp.material.material.name, "cc-red");
        EXPECT_EQ(ramp.material_end->material.name, "cc-blue");
        EXPECT_EQ(ramp.material_end->key, 2);
    }
    EXPECT_EQ(exhibit.objects.at(2).method, MethodChoice(Method::spectral));
    EXPECT_EQ(exhibit.objects.at(1).method, MethodChoice(Method::tristimulus));
}

TEST(Load, Compare) {
    const Exhibit exhibit =
        exhibit_of("[compare]\nsplit = 640px\nline = 3\nleft.method = rgb\nleft.lamp = A\n"
                   "right.working_space = NTSC-C\nright.strength = 7\n");
    ASSERT_TRUE(exhibit.compare);
    EXPECT_EQ(exhibit.compare->split_px, 640);
    EXPECT_EQ(exhibit.compare->line_px, 3);
    EXPECT_EQ(exhibit.compare->left.method, MethodChoice(Method::rgb));
    EXPECT_EQ(exhibit.compare->left.lamp->lamp.name, "A");
    EXPECT_EQ(exhibit.atlas.lamps.at(static_cast<std::size_t>(exhibit.compare->left.lamp->key)).name, "A");
    EXPECT_FALSE(exhibit.compare->left.strength);
    EXPECT_EQ(exhibit.compare->left.working_space, nullptr);
    EXPECT_FALSE(exhibit.compare->right.method || exhibit.compare->right.lamp);
    EXPECT_EQ(exhibit.compare->right.working_space->name, "NTSC-C");
    EXPECT_EQ(exhibit.compare->right.strength, 7);
}

TEST(Load, CompareWithoutValuesSharesEverything) {
    const Exhibit exhibit = exhibit_of("[compare]\n");
    ASSERT_TRUE(exhibit.compare);
    EXPECT_EQ(exhibit.compare->split, 0.5);
    EXPECT_FALSE(exhibit.compare->split_px);
    EXPECT_EQ(exhibit.compare->line_px, 0);
}

TEST(Load, SetsBeatTheFile) {
    const Exhibit exhibit =
        exhibit_of("[lamp.1]\nspectrum = F11\n[display]\nmatrix = 1 0 0 0 1 0 0 0 1\n",
                   {"lamp.1.spectrum=A", "compare.left.method=rgb",
                    "display.matrix=", "display.working_space=sRGB-E", "scene.kind=loaf"});
    EXPECT_EQ(exhibit.lamps.at(0).lamp.name, "A");
    EXPECT_EQ(exhibit.compare->left.method, MethodChoice(Method::rgb));
    EXPECT_FALSE(exhibit.display.matrix);
    EXPECT_EQ(exhibit.display.working_space->name, "sRGB-E");
    EXPECT_EQ(exhibit.objects.at(0).name, "slice-1");
}

TEST(Load, PathsStartAtTheFileThatNamesThem) {
    const TestFolder folder;
    std::filesystem::create_directories(folder / "deep");
    write_file(folder / "deep/lamp.csv", "wavelength_nm,tube\n380,1\n700,2\n");
    write_file(folder / "deep/a.ini", "[lamp.1]\nspectrum = lamp.csv\n");
    EXPECT_EQ(load_exhibit(folder / "deep/a.ini", with_quick_rows())
                  .lamps.at(0)
                  .lamp.spectrum.continuum.value.back(),
              2);
    const std::string here = (folder / "deep/lamp.csv").string();
    EXPECT_EQ(exhibit_of("", {"lamp.1.spectrum=" + here}).lamps.at(0).lamp.spectrum.continuum.value.back(),
              2);
}

TEST(Load, DoubtsAboutSpectraAreWarningsWithTheirPlace) {
    const TestFolder folder;
    write_file(folder / "lamp.csv", "wavelength_nm,tube\n380,1\n900,1\n");
    write_file(folder / "a.ini", "[lamp.1]\nspectrum = lamp.csv\n");
    std::vector<std::string> warnings;
    load_exhibit(folder / "a.ini", with_quick_rows(), &warnings);
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_THAT(warnings[0], testing::StartsWith((folder / "a.ini").string() + ":2: "));
}

TEST(Load, WhatAnEvenlyLitSceneCannotShowIsAWarning) {
    std::vector<std::string> warnings;
    exhibit_of(
        "[scene]\nkind = patches\n[lamp.1]\nposition = 1 1 1\nshadow = yes\n[object.patch-1]\nspecular = 1\n",
        {}, &warnings);
    EXPECT_THAT(warnings,
                ElementsAre("k.ini:4: position has no effect in scene patches, which is evenly lit",
                            "k.ini:5: shadow has no effect in scene patches, which is evenly lit",
                            "k.ini:7: specular has no effect in scene patches, which is evenly lit"));
}

TEST(Load, AMissingFileIsNamed) {
    EXPECT_EQ(error_of([] { load_exhibit("no/such.ini"); }),
              "cannot read no/such.ini: there is no such file");
}

} // namespace
} // namespace metamer
