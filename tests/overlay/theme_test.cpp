#include "overlay/theme.h"

#include <gtest/gtest.h>

#include "color/grid.h"
#include "overlay/contrast.h"

namespace metamer {
namespace {

constexpr Srgb kBlack{0, 0, 0}, kWhite{255, 255, 255};
constexpr double kLeastContrast = 4.5; // WCAG 2.1, 1.4.3

TEST(Contrast, IsThatOfWcag) {
    EXPECT_NEAR(contrast(kBlack, kWhite), 21, 1e-9);
    EXPECT_NEAR(contrast(kWhite, kWhite), 1, 1e-12);
    // The least gray that passes on white, and the next that does not (webaim.org's checker).
    EXPECT_NEAR(contrast({0x76, 0x76, 0x76}, kWhite), 4.54, 0.005);
    EXPECT_NEAR(contrast(kWhite, {0x77, 0x77, 0x77}), 4.48, 0.005);
    EXPECT_NEAR(relative_luminance({255, 0, 0}), 0.2126, 1e-12);
}

TEST(Tones, KeepTheirContrastWhateverShinesThrough) {
    for (const auto& [name, tone] : kTones)
        for (const Srgb& under : {kBlack, kWhite, Srgb{255, 255, 0}}) {
            const Srgb ground = over(tone.ground, tone.alpha, under);
            EXPECT_GE(contrast(tone.ink, ground), kLeastContrast) << name;
            EXPECT_GE(contrast(tone.faded, ground), kLeastContrast) << name;
        }
}

TEST(Tones, FramesAndMarksStandOutFromWhatTheyChoose) {
    // WCAG 2.1, 1.4.11: 3 for what is no text.
    for (const Srgb& ground : {kTileTone.ground, kChosenTone.ground, kBackdrop})
        EXPECT_GE(contrast(kAmber, ground), 3);
}

TEST(WavelengthColors, GoFromVioletOverGreenToRed) {
    const std::vector<Srgb>& colors = wavelength_colors();
    ASSERT_EQ(colors.size(), kIntervals);
    const auto at = [&](int nm) { return colors[static_cast<std::size_t>((nm - 385) / 5)]; };
    EXPECT_EQ(at(530), (Srgb{0, 255, 0}));
    EXPECT_EQ(at(640), (Srgb{255, 0, 0}));
    EXPECT_EQ(at(465)[2], 255);
    EXPECT_LT(at(465)[0], 30);
    // Violet: blue with some red. Yellow: both red and green.
    EXPECT_GT(at(430)[0], 60);
    EXPECT_EQ(at(430)[1], 0);
    EXPECT_GT(at(575)[0], 200);
    EXPECT_GT(at(575)[1], 200);
    EXPECT_EQ(at(575)[2], 0);
}

TEST(WavelengthColors, AreReadableToTheEndsOfSight) {
    const std::vector<Srgb>& colors = wavelength_colors();
    for (const Srgb& color : colors)
        EXPECT_GE(std::max({color[0], color[1], color[2]}), 150);
    EXPECT_LT(colors.front()[2], 200);
    EXPECT_LT(colors.back()[0], 200);
}

TEST(Over, MixesAsLayersDo) {
    EXPECT_EQ(over({100, 0, 200}, 1, kWhite), (Srgb{100, 0, 200}));
    EXPECT_EQ(over({100, 0, 200}, 0, kWhite), kWhite);
    EXPECT_EQ(over({100, 0, 200}, 0.5, {0, 100, 0}), (Srgb{50, 50, 100}));
}

} // namespace
} // namespace metamer
