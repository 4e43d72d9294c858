// Whole pixels by every method: against each other, against the reference, under adaptation and strength.
#include "methods/shade.h"

#include <cmath>
#include <gtest/gtest.h>

#include "color/adaptation.h"
#include "color/difference.h"
#include "methods/stock.h"

namespace metamer::test {
namespace {

Xyz xyz(Method method, const Pixel& pixel) {
    return shade_xyz<double>(method, pixel, stock().sight());
}

EncodedRgb8 rgb8(Method method, const Pixel& pixel, const Sight& sight) {
    return shade_rgb8<double>(method, pixel, sight);
}

double error_of(Method method, const std::string& lamp, const std::string& material) {
    const Xyz reference = reference_xyz(find_lamp(lamp).spectrum, find_material(material).spectrum);
    return delta_e_2000(xyz(method, stock().pair(lamp, material)), reference);
}

// The first test of everything: under equal energy the thesis's two renderings are one.
TEST(Shade, UnderEqualEnergyTristimulusIsSpectral) {
    for (const Material& material : library_materials()) {
        const Pixel pixel = stock().pair("E", material.name);
        EXPECT_LE(steps(rgb8(Method::tristimulus, pixel, stock().sight()),
                        rgb8(Method::spectral, pixel, stock().sight())),
                  1)
            << material.name;
    }
}

// The further the lamp is from E, the more they part.
TEST(Shade, AwayFromEqualEnergyTheyPart) {
    const auto parting = [](const std::string& lamp) {
        double sum = 0;
        for (const std::string& name : find_material_set("colorchecker")->materials) {
            const Pixel pixel = stock().pair(lamp, name);
            sum += delta_e_2000(xyz(Method::tristimulus, pixel), xyz(Method::spectral, pixel));
        }
        return sum / 24;
    };
    EXPECT_LT(parting("E"), 0.15);
    EXPECT_GT(parting("D65"), parting("E"));
    EXPECT_GT(parting("A2800"), parting("A3200"));
    EXPECT_GT(parting("A3200"), parting("D55"));
    EXPECT_GT(parting("NIST-LPS"), 5);
}

// Gray under any lamp is the lamp: the reference for one pair by hand, and nothing for a method to get wrong.
TEST(Shade, AGrayMaterialHasTheLampsColorByEveryMethod) {
    Pixel pixel = stock().pair("F2", "crayon-white");
    Reflectance gray;
    gray.value.fill(0.5);
    const std::vector<double> full_gray(kReferenceGrid.count, 0.5);
    pixel.material = {&gray, &full_gray};
    const Xyz lamp = reference_white(find_lamp("F2").spectrum);
    for (const MethodInfo& info : kMethods) {
        const Xyz c = xyz(info.method, pixel);
        EXPECT_NEAR(c.x, 0.5 * lamp.x, 1.5e-3) << info.name;
        EXPECT_NEAR(c.y, 0.5, info.method == Method::rgb ? 1.5e-3 : 1e-9) << info.name;
        EXPECT_NEAR(c.z, 0.5 * lamp.z, 1.5e-3) << info.name;
    }
}

// 8 bits of lamp and material cost up to two units, most where black has eight levels; black crayons and
// single wavelengths, of which hardly a level is left, and line lamps cost more. What the bounds are for: a
// wrong row, a wrong table or a shifted grid is tens of units off.
TEST(Shade, SpectralIsNearTheReferenceForEveryLampAndMaterial) {
    double sum = 0;
    int pairs = 0;
    for (const Lamp& lamp : library_lamps())
        for (const std::string& name : find_material_set("colorchecker")->materials) {
            const Pixel pixel = stock().pair(lamp.name, name);
            const Xyz reference = reference_xyz(*pixel.lamps[0].full, *pixel.material.full);
            const double error = delta_e_2000(xyz(Method::spectral, pixel), reference);
            EXPECT_LT(error, lamp.name == "krypton" || lamp.name == "NIST-LPS" ? 4 : 2.4)
                << lamp.name << ' ' << name;
            sum += error;
            ++pairs;
        }
    EXPECT_LT(sum / pairs, 0.25);
}

TEST(Shade, ThreeNumbersAreFurtherOff) {
    EXPECT_GT(error_of(Method::tristimulus, "A2800", "cc-blue"),
              10 * error_of(Method::spectral, "A2800", "cc-blue"));
    EXPECT_GT(error_of(Method::rgb, "NIST-LPS", "cc-cyan"), 5);
}

TEST(Shade, RgbIsExactUnderTheWorkingSpacesOwnWhite) {
    EXPECT_LT(error_of(Method::rgb, "D65", "cc-orange"), 0.4);
}

Sight adapted_to(const Pixel& pixel) {
    Sight sight = stock().sight();
    sight.output.adaptation =
        bradford(lamp_xyz(*pixel.lamps[0].row, *sight.seen), xyz_of(working_spaces()[0].white));
    return sight;
}

// Before a lamp that the eye has adapted to, its three numbers are those of white.
TEST(Shade, RgbKnowsTheLampAsTheAdaptedEyeSeesIt) {
    const Pixel pixel = stock().pair("A2800", "cc-orange");
    const Emission& lamp = *pixel.lamps[0].row;
    for (double number : lamp_numbers(Method::rgb, lamp, stock().seen(), adapted_to(pixel).output))
        EXPECT_NEAR(number, 1, 1e-6);
    EXPECT_GT(lamp_numbers(Method::rgb, lamp, stock().seen(), stock().sight().output)[0], 1.5);
}

TEST(Shade, XyzIsThatBeforeAdaptation) {
    const Pixel pixel = stock().pair("A2800", "cc-orange");
    for (const MethodInfo& info : kMethods) {
        const Xyz a = shade_xyz<double>(info.method, pixel, adapted_to(pixel));
        const Xyz b = xyz(info.method, pixel);
        EXPECT_NEAR(a.x, b.x, 1e-12) << info.name;
        EXPECT_NEAR(a.y, b.y, 1e-12) << info.name;
        EXPECT_NEAR(a.z, b.z, 1e-12) << info.name;
    }
}

// And what is shown is that after it: a white crayon by lamplight is yellow, to the adapted eye nearly white.
TEST(Shade, AdaptationReachesWhatIsShownByEveryMethod) {
    const Pixel pixel = stock().pair("A2800", "cc-neutral-8");
    for (const MethodInfo& info : kMethods) {
        const EncodedRgb8 plain = rgb8(info.method, pixel, stock().sight());
        const EncodedRgb8 adapted = rgb8(info.method, pixel, adapted_to(pixel));
        EXPECT_GT(plain.r - plain.b, 60) << info.name;
        EXPECT_LT(std::abs(adapted.r - adapted.b), 12) << info.name;
    }
}

TEST(Shade, StrengthScalesLightByEveryMethod) {
    Sight linear = stock().sight();
    linear.output.transfer = Transfer::none;
    for (const MethodInfo& info : kMethods) {
        const auto green = [&](double strength) {
            return rgb8(info.method, stock().pair("D65", "cc-neutral-5", strength), linear);
        };
        EXPECT_NEAR(green(2).g, 2 * green(1).g, 1) << info.name;
        EXPECT_GT(green(1).g, 20) << info.name;
        EXPECT_EQ(green(0), (EncodedRgb8{0, 0, 0})) << info.name;
    }
}

TEST(TapLayers, AreWhatTheLightPassesAtEachTap) {
    Pixel pixel = stock().pair("D65", "cc-red");
    const Taps taps{{450, 550.5, 650}, {std::vector<Xyz>(3)}};
    for (const TapLayers<double>& none : tap_layers(pixel, taps)) {
        EXPECT_EQ(none.medium_log2, 0);
        EXPECT_EQ(none.other, 0);
    }
    pixel.medium = stock().layer("glass-cobalt");
    pixel.thickness = 3; // is the pixel's, not the taps'
    pixel.other = stock().layer("cc-blue");
    const auto layers = tap_layers(pixel, taps);
    ASSERT_EQ(layers.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(std::exp2(layers[i].medium_log2), pixel.medium->at(taps.wavelength_nm[i]), 1e-12) << i;
        EXPECT_EQ(layers[i].other, pixel.other->at(taps.wavelength_nm[i])) << i;
    }
    Reflectance opaque;
    pixel.medium = Layer{&opaque, nullptr};
    EXPECT_EQ(tap_layers(pixel, taps)[0].medium_log2, -16) << "kLeastTransmittance: logarithms are finite";
}

TEST(Output, BoundsLightBeforeTheMatrix) {
    const auto bright = to_output<Float16>(rgb_from_xyz(working_spaces()[0]),
                                           {Float16(65000), Float16(65000), Float16(65000)});
    EXPECT_TRUE(std::isfinite(static_cast<float>(bright.r)));
    EXPECT_TRUE(std::isfinite(static_cast<float>(bright.b)));
}

} // namespace
} // namespace metamer::test
