// Lamps and materials by formula.
#include "spectra/formulas.h"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "color/colorimetry.h"
#include "color/resample.h"
#include "spectra/daylight.h"
#include "spectra/gaussian.h"
#include "spectra/srgb_reflectance.h"

namespace metamer {
namespace {

std::string lamp_refusal(const std::string& name) {
    try {
        find_lamp(name);
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), Exit::bad_input);
        return error.what();
    }
    return "taken";
}

std::string material_refusal(const std::string& name) {
    try {
        find_material(name);
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), Exit::bad_input);
        return error.what();
    }
    return "taken";
}

double energy(const Curve& curve) {
    double sum = 0;
    for (std::size_t i = 0; i + 1 < curve.value.size(); ++i)
        sum += 0.5 * (curve.value[i] + curve.value[i + 1]) *
               (curve.wavelength_nm[i + 1] - curve.wavelength_nm[i]);
    return sum;
}

TEST(Gaussian, HasItsClosedFormEnergyHalfWidthAndPeak) {
    for (const double fwhm : {0.1, 0.5, 3.0, 15.9, 16.0, 20.0, 60.0}) {
        const Curve c = gaussian(540.3, fwhm);
        EXPECT_NEAR(energy(c), fwhm * std::sqrt(std::numbers::pi / (4 * std::numbers::ln2)), 1e-9 * fwhm)
            << fwhm;
        EXPECT_TRUE(std::is_sorted(c.wavelength_nm.begin(), c.wavelength_nm.end(), std::less_equal<>()))
            << fwhm;
        EXPECT_GE(c.wavelength_nm.front(), 360);
        EXPECT_LE(c.wavelength_nm.back(), 830);
    }
    EXPECT_DOUBLE_EQ(gaussian_at(540, 540, 20), 1);
    EXPECT_NEAR(gaussian_at(530, 540, 20), 0.5, 1e-15);
}

TEST(Gaussian, KeepsItsEnergyAndCentroidOnTheGrid) {
    for (const double fwhm : {0.5, 5.0, 30.0}) {
        const std::vector<double> power =
            resample(find_lamp("gauss:541.7:" + std::to_string(fwhm)).spectrum, kThesisGrid);
        double sum = 0, moment = 0;
        for (std::size_t i = 0; i < power.size(); ++i) {
            sum += power[i] * kThesisGrid.step_nm;
            moment += power[i] * kThesisGrid.step_nm * kThesisGrid.wavelength_nm(i);
        }
        EXPECT_NEAR(sum, fwhm * std::sqrt(std::numbers::pi / (4 * std::numbers::ln2)), 1e-6 * fwhm);
        EXPECT_NEAR(moment / sum, 541.7, 1e-4) << fwhm;
    }
}

TEST(Gaussian, NarrowMaterialReflectsItsShareOfAnInterval) {
    const std::vector<double> r = resample(find_material("gauss:540:0.5").spectrum, kThesisGrid);
    // Its area, shared by hats of area 5 nm: a neighbor gets the mean of its distance to one side, sigma /
    // sqrt(2 pi).
    const double area = 0.5 * std::sqrt(std::numbers::pi / (4 * std::numbers::ln2));
    const double sigma = 0.5 / std::sqrt(8 * std::numbers::ln2);
    const double beside = area / 5 * sigma / std::sqrt(2 * std::numbers::pi) / 5;
    EXPECT_NEAR(r[30], beside, 1e-2 * beside);
    EXPECT_NEAR(r[31], area / 5 - 2 * beside, 1e-2 * area / 5);
}

TEST(Formulas, AreNamedInOneWay) {
    EXPECT_EQ(find_lamp("Planck: 2856.0").name, "planck:2856");
    EXPECT_EQ(find_lamp("daylight:5000").name, "daylight:5000");
    EXPECT_EQ(find_lamp("GAUSS:530:20").name, "gauss:530:20");
    EXPECT_EQ(find_lamp("line:589.3").name, "line:589.3");
    EXPECT_EQ(find_material("gauss:530:20").name, "gauss:530:20");
    EXPECT_EQ(find_material("rgb:ed0a3f").name, "rgb:ED0A3F");
    EXPECT_EQ(find_material("Absorb: 590.0:50:1").name, "absorb:590:50:1");
    EXPECT_EQ(find_material("absorb:540:50:.5:590:50:0.9").name, "absorb:540:50:0.5:590:50:0.9");
    EXPECT_THAT(find_material("absorb:590:50:1").description, testing::HasSubstr("computed"));
    for (const char* name : {"planck:2856", "daylight:5000", "gauss:530:20", "line:589.3"})
        EXPECT_THAT(find_lamp(name).description, testing::HasSubstr("computed"));
    EXPECT_THAT(find_material("rgb:808080").description, testing::HasSubstr("modelled"));
}

TEST(Formulas, GiveWhatTheySay) {
    const LampSpectrum line = find_lamp("line:589.3").spectrum;
    ASSERT_EQ(line.lines.size(), 1u);
    EXPECT_EQ(line.lines[0].wavelength_nm, 589.3);
    EXPECT_TRUE(line.continuum.value.empty());
    const std::vector<double> shared = resample(line, kThesisGrid);
    EXPECT_NEAR(shared[40] * 5, 0.14, 1e-12) << "585 nm";
    EXPECT_NEAR(shared[41] * 5, 0.86, 1e-12) << "590 nm";
    const Chromaticity d = chromaticity(reference_white(find_lamp("daylight:4500").spectrum));
    EXPECT_NEAR(d.x, daylight_chromaticity(4500).x, 5e-4);
    const Chromaticity a = chromaticity(reference_white(find_lamp("planck:2855.5").spectrum));
    EXPECT_NEAR(a.x, 0.4476, 2e-4);
    EXPECT_EQ(srgb_code_under_d65(find_material("rgb:ED0A3F").spectrum), (EncodedRgb8{0xED, 0x0A, 0x3F}));
}

TEST(Formulas, NameTheRangeTheyKeep) {
    EXPECT_EQ(lamp_refusal("planck:200"),
              "cannot compute planck:200: temperature 200 K is outside 500..100000 K");
    EXPECT_EQ(lamp_refusal("daylight:3999"),
              "cannot compute daylight:3999: color temperature 3999 K is outside 4000..25000 K");
    EXPECT_EQ(lamp_refusal("daylight:25001"),
              "cannot compute daylight:25001: color temperature 25001 K is outside 4000..25000 K");
    EXPECT_EQ(lamp_refusal("gauss:300:20"),
              "cannot compute gauss:300:20: wavelength 300 nm is outside 360..830 nm");
    EXPECT_EQ(lamp_refusal("gauss:530:0"),
              "cannot compute gauss:530:0: width (FWHM) 0 nm is outside 0.1..500 nm");
    EXPECT_EQ(lamp_refusal("line:900"), "cannot compute line:900: wavelength 900 nm is outside 360..830 nm");
    EXPECT_NE(lamp_refusal("planck:nan"), "taken");
    EXPECT_EQ(lamp_refusal("planck:hot"), "cannot compute planck:hot: temperature is no number: `hot`");
    EXPECT_EQ(lamp_refusal("planck:"), "cannot compute planck:: temperature is no number: ``");
    EXPECT_EQ(lamp_refusal("gauss:530"), "cannot compute gauss:530: gauss: takes 2 numbers, here are 1");
    EXPECT_EQ(lamp_refusal("line:500:3"), "cannot compute line:500:3: line: takes 1 number, here are 2");
}

TEST(Formulas, RefuseWhatTheyCannotBe) {
    EXPECT_EQ(lamp_refusal("plank:3000"), "cannot compute plank:3000: there is no formula plank:; did you "
                                          "mean \"planck\"? (planck:K, daylight:K, "
                                          "gauss:CENTER:FWHM, line:NM, rgb:RRGGBB, "
                                          "absorb:CENTER:FWHM:DENSITY...)");
    EXPECT_NE(lamp_refusal(":"), "taken");
    EXPECT_EQ(lamp_refusal("rgb:FF0000"), "cannot compute rgb:FF0000: rgb: makes a material, not a lamp");
    EXPECT_EQ(material_refusal("planck:3000"),
              "cannot compute planck:3000: planck: makes a lamp, not a material");
    EXPECT_EQ(
        material_refusal("line:589"),
        "cannot compute line:589: a line has no width that a material could reflect; take gauss:CENTER:FWHM");
    EXPECT_EQ(material_refusal("rgb:12345"),
              "cannot compute rgb:12345: rgb: takes six hexadecimal digits, RRGGBB");
    EXPECT_NE(material_refusal("rgb:"), "taken");
}

TEST(Formulas, RefuseMediaThatAreNone) {
    EXPECT_EQ(lamp_refusal("absorb:590:50:1"),
              "cannot compute absorb:590:50:1: absorb: makes a material, not a lamp");
    EXPECT_EQ(
        material_refusal("absorb:590:50"),
        "cannot compute absorb:590:50: absorb: takes three numbers a band, CENTER:FWHM:DENSITY, here are 2");
    EXPECT_EQ(
        material_refusal("absorb:590:50:1:600"),
        "cannot compute absorb:590:50:1:600: absorb: takes three numbers a band, CENTER:FWHM:DENSITY, here "
        "are 4");
    EXPECT_EQ(material_refusal("absorb:590:50:-0.1"),
              "cannot compute absorb:590:50:-0.1: density -0.1 is outside 0..10");
    EXPECT_EQ(material_refusal("absorb:590:50:11"),
              "cannot compute absorb:590:50:11: density 11 is outside 0..10");
    EXPECT_EQ(material_refusal("absorb:590:50:1:900:50:1"),
              "cannot compute absorb:590:50:1:900:50:1: wavelength 900 nm is outside 360..830 nm");
    EXPECT_EQ(material_refusal("absorb:590:50:thick"),
              "cannot compute absorb:590:50:thick: density is no number: `thick`");
    EXPECT_NE(material_refusal("absorb:"), "taken");
}

TEST(Formulas, RefuseLampsWithoutLightOnTheGrid) {
    EXPECT_EQ(lamp_refusal("line:800"), "cannot use line:800: it has no light within 385..700 nm");
    EXPECT_EQ(lamp_refusal("gauss:360:0.5"), "cannot use gauss:360:0.5: it has no light within 385..700 nm");
}

} // namespace
} // namespace metamer
