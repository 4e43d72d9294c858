// The sets of materials.
#include <algorithm>
#include <cmath>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "color/colorimetry.h"
#include "color/grid.h"
#include "color/resample.h"
#include "spectra/library.h"
#include "spectra/sets.h"
#include "spectra/srgb_reflectance.h"
#include "spectra/tables.h"

namespace metamer {
namespace {

double luminance_under_e(const std::string& material) {
    return reference_xyz(find_lamp("E").spectrum, find_material(material).spectrum).y;
}

TEST(MaterialSets, AreSixEachOneAtlasFull) {
    std::vector<std::string> names;
    for (const MaterialSet& set : material_sets()) {
        names.push_back(set.name);
        EXPECT_LE(set.materials.size(), 63u) << set.name;
        EXPECT_FALSE(set.description.empty()) << set.name;
    }
    EXPECT_THAT(names,
                testing::ElementsAre("colorchecker", "single", "weighted", "empirical", "crayons", "media"));
    ASSERT_NE(find_material_set(" Crayons "), nullptr);
    EXPECT_EQ(find_material_set("crayon"), nullptr);
}

TEST(MaterialSets, NameEveryMaterialOnceInTheLibrarysOrder) {
    std::vector<std::string> listed, built;
    for (const MaterialSet& set : material_sets())
        listed.insert(listed.end(), set.materials.begin(), set.materials.end());
    for (const Material& material : library_materials())
        built.push_back(material.name);
    EXPECT_EQ(listed, built);
    EXPECT_EQ(std::set<std::string>(built.begin(), built.end()).size(), built.size());
    EXPECT_EQ(listed, material_names());
}

TEST(MaterialSets, HoldReflectances) {
    for (const Material& material : library_materials()) {
        EXPECT_FALSE(material.description.empty()) << material.name;
        EXPECT_FALSE(material.source.empty()) << material.name;
        for (const double r : material.spectrum.curve.value)
            EXPECT_TRUE(r >= 0 && r <= 1) << material.name << ": " << r;
    }
}

TEST(ColorChecker, HasTheChartsColors) {
    const MaterialSet& chart = *find_material_set("colorchecker");
    ASSERT_EQ(chart.materials.size(), 24u);
    EXPECT_EQ(chart.materials.front(), "cc-dark-skin");
    EXPECT_EQ(chart.materials.back(), "cc-black");
    // Rows of the chart under D65: the primaries lead in their channel, the grays descend.
    const auto code = [](const char* name) { return srgb_code_under_d65(find_material(name).spectrum); };
    EXPECT_GT(code("cc-red").r, code("cc-red").g + 80);
    EXPECT_GT(code("cc-green").g, code("cc-green").r + 60);
    EXPECT_GT(code("cc-blue").b, code("cc-blue").r + 60);
    EXPECT_GT(code("cc-yellow").g, code("cc-yellow").b + 100);
    for (std::size_t i = 18; i + 1 < 24; ++i)
        EXPECT_GT(luminance_under_e(chart.materials[i]), luminance_under_e(chart.materials[i + 1]));
    EXPECT_NEAR(luminance_under_e("cc-white"), 0.90, 0.02);
    EXPECT_THAT(find_material("cc-red").description, testing::HasSubstr("measured"));
}

TEST(SingleWavelengths, AreOneInOneInterval) {
    const MaterialSet& set = *find_material_set("single");
    ASSERT_EQ(set.materials.size(), 63u);
    EXPECT_EQ(set.materials.front(), "single-390");
    EXPECT_EQ(set.materials.back(), "single-700");
    for (std::size_t k = 0; k < set.materials.size(); ++k) {
        const Reflectance r = sample_material(find_material(set.materials[k]).spectrum);
        for (std::size_t i = 0; i < kIntervals; ++i)
            EXPECT_DOUBLE_EQ(r.value[i], i == k + 1 ? 1.0 : 0.0) << set.materials[k] << " at " << i;
    }
}

TEST(WeightedWavelengths, ShareOneLuminanceWhereTheyCan) {
    const MaterialSet& set = *find_material_set("weighted");
    const double level = luminance_under_e("weighted-555");
    int equal = 0;
    for (const std::string& name : set.materials) {
        const double luminance = luminance_under_e(name);
        const auto& v = find_material(name).spectrum.curve.value;
        EXPECT_LE(luminance, level * (1 + 1e-12)) << name;
        if (std::abs(luminance - level) < 1e-12 * level)
            ++equal;
        else
            EXPECT_EQ(*std::max_element(v.begin(), v.end()), 1)
                << name << " is darker, yet not at full reflectance";
    }
    EXPECT_EQ(equal, 32) << "more than half of 63";
}

TEST(Empirical, HasSeveralPeaksAndDipsAndKeepsOffTheLimits) {
    const MaterialSet& set = *find_material_set("empirical");
    EXPECT_GE(set.materials.size(), 15u);
    for (const std::string& name : set.materials) {
        const Material material = find_material(name);
        EXPECT_THAT(material.description, testing::HasSubstr("constructed, not measured"));
        const auto& v = material.spectrum.curve.value;
        EXPECT_GE(*std::min_element(v.begin(), v.end()), 0.02) << name;
        EXPECT_LE(*std::max_element(v.begin(), v.end()), 0.98) << name;
        int turns = 0;
        for (std::size_t i = 1; i + 1 < v.size(); ++i)
            turns += (v[i] - v[i - 1]) * (v[i + 1] - v[i]) < 0;
        EXPECT_GE(turns, 3) << name;
    }
}

TEST(Crayons, HaveCrayolasColorsUnderD65) {
    const MaterialSet& set = *find_material_set("crayons");
    EXPECT_THAT(set.materials,
                testing::ElementsAre("crayon-white", "crayon-gray", "crayon-apricot", "crayon-carnation-pink",
                                     "crayon-red", "crayon-orange", "crayon-yellow", "crayon-green-yellow",
                                     "crayon-green", "crayon-blue-green", "crayon-blue", "crayon-cerulean",
                                     "crayon-violet", "crayon-brown", "crayon-black"));
    for (const std::string& name : set.materials) {
        const Material crayon = find_material(name);
        const std::string code = srgb_code_text(srgb_code_under_d65(crayon.spectrum));
        EXPECT_EQ(crayon.description,
                  "modelled from Crayola's published sRGB color " + code + "; no measurement");
    }
    EXPECT_THAT(find_material("crayon-red").description, testing::HasSubstr("ED0A3F"));
    EXPECT_EQ(crayon_names(), set.materials);
}

TEST(Media, HaveDensityOneAtMostOnTheGridAndSayThatTheyAreComputed) {
    const MaterialSet& set = *find_material_set("media");
    EXPECT_GE(set.materials.size(), 8u);
    EXPECT_EQ(media_names(), set.materials);
    for (const std::string& name : set.materials) {
        const Material medium = find_material(name);
        double least = 1;
        for (std::size_t i = 0; i < kThesisGrid.count; ++i)
            least = std::min(least, value_at_held(medium.spectrum.curve, kThesisGrid.wavelength_nm(i)));
        EXPECT_NEAR(least, 0.1, 1e-12) << name;
        EXPECT_THAT(medium.description, testing::HasSubstr("computed, not measured"));
        EXPECT_THAT(medium.source, testing::HasSubstr("Gaussian bands at "));
    }
}

// Color names, as chromaticity under D65, at density 1; neodymium glass is lilac by daylight.
TEST(Media, HaveTheColorsOfTheirNames) {
    const auto code = [](const char* name) { return srgb_code_under_d65(find_material(name).spectrum); };
    for (const char* blue : {"glass-cobalt", "liquid-brilliant-blue", "liquid-copper"})
        EXPECT_GT(code(blue).b, code(blue).r + 40) << blue;
    EXPECT_GT(code("glass-ruby").r, code("glass-ruby").g + 80);
    EXPECT_GT(code("liquid-allura-red").r, code("liquid-allura-red").g + 60);
    EXPECT_GT(code("glass-chrome").g, std::max(code("glass-chrome").r, code("glass-chrome").b) + 10);
    EXPECT_GT(code("glass-amber").r, code("glass-amber").b + 60);
    EXPECT_GT(code("liquid-tartrazine").g, code("liquid-tartrazine").b + 60);
    EXPECT_GT(code("liquid-permanganate").r, code("liquid-permanganate").g + 40);
    EXPECT_GT(code("liquid-permanganate").b, code("liquid-permanganate").g + 40);
    EXPECT_GT(code("glass-neodymium").b, code("glass-neodymium").g);
    EXPECT_LT(luminance_under_e("glass-neodymium"), 0.9);
}

} // namespace
} // namespace metamer
