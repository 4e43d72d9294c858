// Lamp x material = eye.
#include "kiosk/product.h"

#include <gmock/gmock.h>

#include "color/working_space.h"
#include "kiosk/desks.h"

namespace metamer {
namespace {

ProductPanel panel_of(const TestDesk& at, const Seen& seen, const std::string& language = "en") {
    return product_panel(at.drawn(), at.plan(), at.spectra(), seen, at.words, language).value();
}

TEST(Product, IsTheLampTimesTheMaterial) {
    const TestDesk at;
    const ProductPanel panel = panel_of(at, {1, "crayon-blue"});
    const Emission lamp = emission(at.drawn().atlas, at.drawn().lamps[0].key);
    const Reflectance material = reflectance(at.drawn().atlas, at.drawn().objects[1].material.key);
    const double peak = *std::max_element(lamp.value.begin(), lamp.value.end());
    for (std::size_t i = 0; i < kIntervals; ++i) {
        EXPECT_FLOAT_EQ(panel.lamp[i], static_cast<float>(lamp.value[i] / peak));
        EXPECT_FLOAT_EQ(panel.material[i], static_cast<float>(material.value[i]));
        EXPECT_FLOAT_EQ(panel.product[i], panel.lamp[i] * panel.material[i]);
    }
    EXPECT_EQ(panel.title, at.words.text("en", "panel.title",
                                         {{"material", at.words.name_of("en", "material", "crayon-blue")},
                                          {"lamp", at.words.name_of("en", "lamp", "F11")}}));
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

TEST(Product, NamesTheDominantLamp) {
    const TestDesk at("[atlas]\nquantization = thesis\n[scene]\nkind = loaf\nmaterials = cc-red\n[lamp.1]\n"
                      "spectrum = A2800\nstrength = 0.2\n[lamp.2]\nspectrum = D65\nstrength = 3\n"
                      "[kiosk]\nlamps = E, F11\n");
    EXPECT_EQ(panel_of(at, {0, "cc-red"}).title,
              at.words.text("en", "panel.title",
                            {{"material", at.words.name_of("en", "material", "cc-red")},
                             {"lamp", at.words.name_of("en", "lamp", "D65")}}));
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
    EXPECT_EQ(names("left.method = packed\nright.method = spectral\n"),
              wavelengths + " | " + wavelengths + " | " + every + " | " + every);
}

} // namespace
} // namespace metamer
