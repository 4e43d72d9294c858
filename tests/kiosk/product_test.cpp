// Lamp x material = eye.
#include "kiosk/product.h"

#include <gmock/gmock.h>

#include "color/resample.h"
#include "color/working_space.h"
#include "kiosk/desks.h"

namespace metamer {
namespace {

ProductPanel panel_of(const TestDesk& at, const Seen& seen, const std::string& language = "en") {
    return product_panel(at.drawn(), at.plan(), at.spectra(), seen, at.words, language).value();
}

using testing::Each;
using testing::FloatNear;

/// The mean over an interval of the thesis's grid of what is known at 1 nm, 383 .. 387 nm for the first.
double mean_at(const std::vector<double>& full, std::size_t interval) {
    const auto middle =
        static_cast<std::size_t>(kThesisGrid.wavelength_nm(interval) - kReferenceGrid.first_nm);
    double sum = 0;
    for (std::size_t i = middle - 2; i <= middle + 2; ++i)
        sum += full[i];
    return sum / 5;
}

std::vector<double> spectrum_of(const std::string& material) {
    return resample(find_material(material).spectrum, kReferenceGrid);
}

/// Of light painted as bars, by the observer's values in the middle of each.
Chromaticity chromaticity_of(const Bars& bars) {
    Xyz sum;
    for (std::size_t i = 0; i < bars.size(); ++i) {
        const auto& seen =
            cie_1931_2deg()[static_cast<std::size_t>(kThesisGrid.wavelength_nm(i) - kReferenceGrid.first_nm)];
        sum = sum + static_cast<double>(bars[i]) * Xyz{seen.x, seen.y, seen.z};
    }
    return chromaticity(sum);
}

/// What is drawn third has the color that the standard's sums give an object; 5 nm bars are as near as this.
void expect_color_of(const ProductPanel& panel, const TestDesk& at, std::size_t object) {
    const ObjectSetting& setting = at.drawn().objects[object];
    const Pixel pixel =
        pixel_of(at.drawn(), at.plan().halves.back().view, at.spectra(), setting, setting.material);
    ASSERT_TRUE(pixel.at_full_resolution());
    const Chromaticity exact = chromaticity(exact_xyz(pixel, at.spectra().exact()));
    EXPECT_NEAR(chromaticity_of(panel.product).x, exact.x, 0.006);
    EXPECT_NEAR(chromaticity_of(panel.product).y, exact.y, 0.006);
}

TEST(Product, IsTheLampTimesTheMaterial) {
    const TestDesk at;
    const ProductPanel panel = panel_of(at, {1, "crayon-blue"});
    const std::vector<double> lamp = reference_lamp(find_lamp("F11").spectrum).power,
                              material = spectrum_of("crayon-blue");
    double peak = 0;
    for (std::size_t i = 0; i < kIntervals; ++i)
        peak = std::max(peak, mean_at(lamp, i));
    for (std::size_t i = 0; i < kIntervals; ++i) {
        EXPECT_FLOAT_EQ(panel.lamp[i], static_cast<float>(mean_at(lamp, i) / peak));
        EXPECT_FLOAT_EQ(panel.material[i], static_cast<float>(mean_at(material, i)));
        EXPECT_FLOAT_EQ(panel.product[i], panel.lamp[i] * panel.material[i]);
    }
    expect_color_of(panel, at, 1);
    EXPECT_EQ(panel.title, at.words.text("en", "panel.title",
                                         {{"material", at.words.name_of("en", "material", "crayon-blue")},
                                          {"lamp", at.words.name_of("en", "lamp", "F11")}}));
}

// Rows are chosen for what the eye sees of them: their ends, where it sees next to nothing, are free.
TEST(Product, ShowsSpectraAndNotTheAtlassRows) {
    const TestDesk at("[scene]\nkind = loaf\nmaterials = crayon-carnation-pink\n[lamp.1]\nspectrum = A2800\n"
                      "[kiosk]\nlamps = A2800, F11\n");
    const Reflectance row = reflectance(at.drawn().atlas, at.drawn().objects[0].material.key);
    const ProductPanel panel = panel_of(at, {0, "crayon-carnation-pink"});
    const std::vector<double> known = spectrum_of("crayon-carnation-pink");
    double farthest = 0;
    for (std::size_t i = 0; i < kIntervals; ++i) {
        EXPECT_FLOAT_EQ(panel.material[i], static_cast<float>(mean_at(known, i)));
        farthest = std::max(farthest, std::abs(row.value[i] - mean_at(known, i)));
    }
    EXPECT_GT(farthest, 0.05) << "the row would have been seen";
    const Bars tile = lamp_bars(at.exhibit.kiosk.lamps[0], at.exhibit.atlas);
    for (std::size_t i = 1; i < kIntervals; ++i) // a light bulb's spectrum only rises there
        EXPECT_GT(tile[i], tile[i - 1]) << kThesisGrid.wavelength_nm(i) << " nm";
    EXPECT_EQ(tile, panel.lamp);
}

TEST(Product, OfSeveralLampsIsTheirSum) {
    const TestDesk at("[atlas]\nquantization = thesis\n[scene]\nkind = loaf\nmaterials = cc-red\n[lamp.1]\n"
                      "spectrum = A2800\nstrength = 2\n[lamp.2]\nspectrum = F11\nstrength = 3\n"
                      "[kiosk]\nlamps = E, F11\n");
    const ProductPanel panel = panel_of(at, {0, "cc-red"});
    EXPECT_EQ(panel.title, at.words.text("en", "panel.title",
                                         {{"material", at.words.name_of("en", "material", "cc-red")},
                                          {"lamp", at.words.text("en", "panel.all_lamps")}}));
    EXPECT_EQ(panel.lamp_name, at.words.text("en", "panel.lamps"));
    const ReferenceLamp bulb = reference_lamp(find_lamp("A2800").spectrum),
                        tube = reference_lamp(find_lamp("F11").spectrum);
    const auto light = [&](std::size_t i) {
        return 2 / bulb.k * mean_at(bulb.power, i) + 3 / tube.k * mean_at(tube.power, i);
    };
    const auto peak = static_cast<std::size_t>(std::ranges::max_element(panel.lamp) - panel.lamp.begin());
    for (std::size_t i = 0; i < kIntervals; ++i)
        EXPECT_NEAR(panel.lamp[i], light(i) / light(peak), 1e-6);
    expect_color_of(panel, at, 0);
}

TEST(Product, OfLampsOfOneSpectrumNamesIt) {
    const TestDesk at("[atlas]\nquantization = thesis\n[scene]\nkind = loaf\nmaterials = cc-red\n[lamp.1]\n"
                      "spectrum = F11\nstrength = 2\n[lamp.2]\nspectrum = F11\nstrength = 3\n"
                      "[kiosk]\nlamps = E, F11\n");
    const ProductPanel panel = panel_of(at, {0, "cc-red"});
    EXPECT_THAT(panel.title, testing::HasSubstr(at.words.name_of("en", "lamp", "F11")));
    EXPECT_EQ(panel.lamp_name, at.words.text("en", "panel.lamp"));
}

TEST(Product, OfGlassIsWhatGetsThroughWhereItIsThickest) {
    const TestDesk at("[scene]\nkind = media\n[lamp.1]\nspectrum = A2800\n[object.wedge]\n"
                      "medium = glass-cobalt\nthickness = 4\n[compare]\nleft.method = rgb\n"
                      "[kiosk]\nlamps = A2800, F11\n");
    const auto wedge = static_cast<std::size_t>(
        std::ranges::find(at.drawn().objects, "wedge", &ObjectSetting::name) - at.drawn().objects.begin());
    const ObjectSetting& object = at.drawn().objects[wedge];
    const ProductPanel panel = panel_of(at, {wedge, object.material.material.name});
    EXPECT_EQ(panel.title, at.words.text("en", "panel.title",
                                         {{"material", at.words.name_of("en", "material", "glass-cobalt")},
                                          {"lamp", at.words.name_of("en", "lamp", "A2800")}}));
    EXPECT_EQ(panel.material_name, at.words.text("en", "panel.medium"));
    std::vector<double> through = spectrum_of("glass-cobalt");
    const std::vector<double> behind = resample(object.material.material.spectrum, kReferenceGrid);
    for (std::size_t i = 0; i < through.size(); ++i)
        through[i] = behind[i] * std::pow(std::max(through[i], kLeastTransmittance), 4);
    for (std::size_t i = 0; i < kIntervals; ++i) {
        EXPECT_NEAR(panel.material[i], mean_at(through, i), 1e-6);
        EXPECT_FLOAT_EQ(panel.product[i], panel.lamp[i] * panel.material[i]);
    }
    expect_color_of(panel, at, wedge);
}

// An atlas file's rows are all that is known of what it holds.
TEST(LampBars, AreTheRowWhereThereIsNoSpectrum) {
    const TestDesk at;
    LampSetting lamp = at.exhibit.kiosk.lamps[2];
    const Emission row = emission(at.exhibit.atlas, lamp.key);
    const double peak = *std::ranges::max_element(row.value);
    lamp.full_resolution = false;
    const Bars tile = lamp_bars(lamp, at.exhibit.atlas);
    for (std::size_t i = 0; i < kIntervals; ++i)
        EXPECT_FLOAT_EQ(tile[i], static_cast<float>(row.value[i] / peak));
    EXPECT_THAT(lamp_bars(at.exhibit.kiosk.lamps[0], at.exhibit.atlas), Each(FloatNear(1, 1e-6F)));
}

// The right half sums wavelengths: its color is the material's own under the lamp, by the standard's sums.
TEST(Product, ItsColorsAreTheHalves) {
    const TestDesk at;
    const ProductPanel panel = panel_of(at, {0, "crayon-red"});
    Pixel pixel;
    const ReferenceLamp tube = reference_lamp(find_lamp("F11").spectrum);
    const Emission row = emission(at.drawn().atlas, at.drawn().lamps[0].key);
    pixel.lamps.push_back({&row, &tube, 1, {}});
    pixel.material = at.spectra().material(at.drawn().objects[0].material.key);
    const Xyz exact = exact_xyz(pixel, at.spectra().exact());
    const std::array<double, 3> rgb =
        rgb_from_xyz(working_spaces()[0]) * std::array{exact.x, exact.y, exact.z};
    const EncodedRgb8 code = encode_rgb8(Transfer::srgb, LinearRgb{rgb[0], rgb[1], rgb[2]});
    EXPECT_EQ(panel.right, (std::array<std::uint8_t, 3>{code.r, code.g, code.b}));
    EXPECT_NE(panel.left, panel.right);
}

TEST(Product, UnderEqualEnergyTheHalvesAgree) {
    TestDesk at;
    at.tap(Part::lamp, 0);
    const ProductPanel panel = panel_of(at, {0, "crayon-red"});
    EXPECT_EQ(panel.difference, at.words.text("en", "difference.same"));
    EXPECT_EQ(panel.number, at.words.text("en", "difference.number", {{"number", "0.1"}}));
}

TEST(Product, HasNothingToDoWithStrength) {
    TestDesk at;
    const ProductPanel before = panel_of(at, {2, "cc-yellow"});
    at.visit.act(SetStrength{7});
    at.lay();
    EXPECT_EQ(panel_of(at, {2, "cc-yellow"}), before);
}

TEST(Product, SpeaksEveryLanguage) {
    const TestDesk at;
    EXPECT_NE(panel_of(at, {0, "crayon-red"}, "de").title, panel_of(at, {0, "crayon-red"}, "en").title);
    EXPECT_NE(panel_of(at, {0, "crayon-red"}, "de").number.find(','), std::string::npos);
}

TEST(Product, IsOfAKeyMapsMaterialToo) {
    const TestDesk at;
    const ProductPanel panel = panel_of(at, {0, "cc-yellow"});
    EXPECT_EQ(panel.material, panel_of(at, {2, "cc-yellow"}).material);
}

TEST(Product, IsNoneOfWhatIsNotThere) {
    const TestDesk at;
    const auto panel = [&](const Seen& seen) {
        return product_panel(at.drawn(), at.plan(), at.spectra(), seen, at.words, "en").has_value();
    };
    EXPECT_TRUE(panel({2, "cc-yellow"}));
    EXPECT_FALSE(panel({3, "cc-yellow"}));
    EXPECT_FALSE(panel({0, "cc-cyan"}));
    EXPECT_FALSE(panel({0, ""}));
}

TEST(Product, KnowsTheBoothsCards) {
    TestDesk at;
    at.tap(Part::mode);
    for (std::size_t i = 0; i < at.drawn().objects.size(); ++i) {
        const ObjectSetting& object = at.drawn().objects[i];
        if (!object.name.starts_with("card"))
            continue;
        const ProductPanel panel = panel_of(at, {i, object.material.material.name});
        const std::string card =
            at.words.text("en", object.name == "card-a" ? "booth.card_a" : "booth.card_b");
        EXPECT_EQ(panel.title,
                  at.words.text("en", "panel.title", {{"material", card}, {"lamp", panel.left_name}}));
        EXPECT_EQ(panel.left_name, at.words.name_of("en", "lamp", "D65"));
        EXPECT_EQ(panel.right_name, at.words.name_of("en", "lamp", "F11"));
    }
}

TEST(HalfName, IsOfAllLampsWhereTheyAreSeveral) {
    const TestDesk at(
        "[atlas]\nquantization = thesis\n[scene]\nkind = patches\nmaterials = cc-red\n[lamp.1]\n"
        "spectrum = E\n[lamp.2]\nspectrum = A2800\n[compare]\nright.lamp = D65\n[kiosk]\n"
        "lamps = E, F11\n");
    const auto name = [&](std::size_t half) {
        return half_name(at.drawn(), at.plan(), half, HalfName::brief, at.words, "en");
    };
    EXPECT_EQ(name(0), at.words.text("en", "panel.all_lamps"));
    EXPECT_EQ(name(1), at.words.name_of("en", "lamp", "D65"));
}

TEST(HalfName, IsWhatTheHalvesDifferIn) {
    const auto names = [](const std::string& halves) {
        const TestDesk at(
            "[atlas]\nquantization = thesis\n[scene]\nkind = patches\nmaterials = cc-red\n[lamp.1]\n"
            "spectrum = E\n[compare]\n" +
            halves + "[kiosk]\nlamps = E, F11\n");
        const auto name = [&](std::size_t half, HalfName kind) {
            return half_name(at.drawn(), at.plan(), half, kind, at.words, "en");
        };
        return name(0, HalfName::full) + " | " + name(1, HalfName::full) + " | " + name(0, HalfName::brief) +
               " | " + name(1, HalfName::brief);
    };
    const Words& words = all_words();
    const auto both = [&](const std::string& key, const std::string& value, const std::string& a,
                          const std::string& b) {
        return words.text("en", key, {{value, a}}) + " | " + words.text("en", key, {{value, b}}) + " | " + a +
               " | " + b;
    };
    const std::string numbers = words.text("en", "half.numbers"),
                      wavelengths = words.text("en", "half.wavelengths"),
                      every = words.text("en", "panel.wavelengths");
    EXPECT_EQ(names("left.method = rgb\nright.method = spectral\n"),
              numbers + " | " + wavelengths + " | " + words.text("en", "panel.numbers") + " | " + every);
    EXPECT_EQ(
        names("left.lamp = D65\nright.lamp = A2800\n"),
        both("half.lamp", "lamp", words.name_of("en", "lamp", "D65"), words.name_of("en", "lamp", "A2800")));
    EXPECT_EQ(names("right.working_space = Adobe-D65\n"),
              both("half.space", "space", "sRGB-D65", "Adobe-D65"));
    for (const auto& [left, right] : {std::pair{"packed", "spectral"}, {"rgb", "tristimulus"}})
        EXPECT_EQ(names("left.method = " + std::string(left) + "\nright.method = " + right + "\n"),
                  words.text("en", "method." + std::string(left)) + " | " +
                      words.text("en", "method." + std::string(right)) + " | " + left + " | " + right);
    const std::string strengths = words.text("en", "slider.strength", {{"factor", "0.50"}}) + " | " +
                                  words.text("en", "slider.strength", {{"factor", "2.0"}});
    EXPECT_EQ(names("left.strength = 0.5\nright.strength = 2\n"), strengths + " | " + strengths);
    EXPECT_EQ(names(""), wavelengths + " | " + wavelengths + " | " + every + " | " + every)
        << "nothing parts them";
}

} // namespace
} // namespace metamer
