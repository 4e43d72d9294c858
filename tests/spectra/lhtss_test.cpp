// The smoothest reflectances of sRGB colors.
#include "spectra/lhtss.h"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "color/colorimetry.h"
#include "color/difference.h"
#include "color/resample.h"
#include "spectra/library.h"
#include "spectra/linear_solve.h"
#include "spectra/srgb_reflectance.h"

namespace metamer {
namespace {

// Knots whose reflectance a test may look at.
bool strictly_inside(const MaterialSpectrum& material) {
    const auto& v = material.curve.value;
    return std::all_of(v.begin(), v.end(), [](double r) { return r > 0 && r < 1; });
}

void expect_exact(const EncodedRgb8& code) {
    const auto material = srgb_reflectance(code);
    ASSERT_TRUE(material) << srgb_code_text(code);
    EXPECT_EQ(srgb_code_text(srgb_code_under_d65(*material)), srgb_code_text(code));
    EXPECT_TRUE(strictly_inside(*material)) << srgb_code_text(code);
}

TEST(LinearSolve, SolvesWithPivotingAndRefusesTheSingular) {
    SquareMatrix a{3};
    const double rows[3][3] = {{0, 2, 1}, {1, 1, 0}, {3, 0, -1}};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            a(i, j) = rows[i][j];
    const auto x = solve(a, {7, 3, 0});
    ASSERT_TRUE(x);
    EXPECT_THAT(*x, testing::ElementsAre(testing::DoubleNear(1, 1e-12), testing::DoubleNear(2, 1e-12),
                                         testing::DoubleNear(3, 1e-12)));
    EXPECT_FALSE(solve(SquareMatrix{2}, {1, 1}));
}

TEST(Lhtss, GivesTheColorsAskedFor) {
    const LampSpectrum d65 = find_lamp("D65").spectrum;
    for (const std::string& patch : find_material_set("colorchecker")->materials) {
        const Xyz target = reference_xyz(d65, find_material(patch).spectrum);
        const auto material = lhtss(target);
        ASSERT_TRUE(material) << patch;
        const Xyz got = reference_xyz(d65, *material);
        EXPECT_NEAR(got.x, target.x, 1e-10) << patch;
        EXPECT_NEAR(got.y, target.y, 1e-10) << patch;
        EXPECT_NEAR(got.z, target.z, 1e-10) << patch;
    }
}

TEST(Lhtss, OfAGrayIsFlat) {
    const auto material = lhtss(0.3 * reference_white(find_lamp("D65").spectrum));
    ASSERT_TRUE(material);
    for (const double r : material->curve.value)
        EXPECT_NEAR(r, 0.3, 1e-9);
}

// Any change of z that keeps the color must make the sum of squared steps greater: that is what "smoothest"
// says.
TEST(Lhtss, IsSmootherThanItsMetamers) {
    const auto sum_of_steps = [](const MaterialSpectrum& material) {
        double sum = 0;
        const auto& r = material.curve.value;
        for (std::size_t i = 0; i + 1 < r.size(); ++i)
            sum += std::pow(std::atanh(2 * r[i + 1] - 1) - std::atanh(2 * r[i] - 1), 2);
        return sum;
    };
    const Material patch = find_material("cc-bluish-green");
    const auto smooth = lhtss(reference_xyz(find_lamp("D65").spectrum, patch.spectrum));
    ASSERT_TRUE(smooth);
    EXPECT_LT(sum_of_steps(*smooth), sum_of_steps(patch.spectrum));
    // A metamer nearby: half way to the patch. Mixtures of metamers are metamers.
    for (const double share : {0.01, 0.1, 0.5}) {
        MaterialSpectrum mixed = *smooth;
        for (std::size_t i = 0; i < mixed.curve.value.size(); ++i)
            mixed.curve.value[i] += share * (patch.spectrum.curve.value[i] - smooth->curve.value[i]);
        EXPECT_LT(sum_of_steps(*smooth), sum_of_steps(mixed)) << share;
    }
}

TEST(Lhtss, RefusesColorsThatNoReflectanceHas) {
    EXPECT_FALSE(lhtss({0.5, 1.01, 0.5})) << "brighter than the perfect reflector";
    EXPECT_FALSE(lhtss({0.1, 0.9, 0.1})) << "a green of 90 %";
    EXPECT_FALSE(lhtss({0.2, -0.1, 0.2})) << "negative light";
    EXPECT_FALSE(lhtss({0.01, 0.0001, 0.2})) << "beyond the spectral locus";
}

TEST(SrgbReflectance, IsExactAcrossTheCube) {
    for (int r = 0; r <= 255; r += 51)
        for (int g = 0; g <= 255; g += 51)
            for (int b = 0; b <= 255; b += 51)
                expect_exact({static_cast<std::uint8_t>(r), static_cast<std::uint8_t>(g),
                              static_cast<std::uint8_t>(b)});
}

TEST(SrgbReflectance, IsExactAtTheEdgesOfTheCube) {
    for (const char* text :
         {"FFFFFE", "FFFEFF", "FEFFFF", "FFFFFD", "FFF0FF", "010000", "000100", "000001", "0000FF", "00FF00",
          "FF0000", "FFFF00", "00FFFF", "FF00FF", "FEFEFE", "010101", "FF0001"})
        expect_exact(*parse_srgb_code(text));
}

TEST(SrgbReflectance, IsDeterministic) {
    const EncodedRgb8 code{12, 200, 77};
    EXPECT_EQ(srgb_reflectance(code)->curve.value, srgb_reflectance(code)->curve.value);
}

TEST(SrgbReflectance, ReadsCodes) {
    EXPECT_EQ(*parse_srgb_code("ED0a3F"), (EncodedRgb8{0xED, 0x0A, 0x3F}));
    EXPECT_EQ(srgb_code_text({0xED, 0x0A, 0x3F}), "ED0A3F");
    for (const char* bad : {"", "ED0A3", "ED0A3F0", "ED0A3G", "-D0A3F", "0xED0A", " ED0A3"})
        EXPECT_FALSE(parse_srgb_code(bad)) << bad;
}

} // namespace
} // namespace metamer
