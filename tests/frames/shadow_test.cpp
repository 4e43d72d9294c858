// Shadow maps as a whole: frames with shadows against frames without, pixel by pixel.
#include <gtest/gtest.h>

#include "frames/frames.h"

namespace metamer {
namespace {

/// How many pixels of two frames are more than a step apart.
int pixels_apart(const Image& a, const Image& b) {
    int apart = 0;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x)
            apart += steps(pixel(a, x, y), pixel(b, x, y)) > 1;
    return apart;
}

const std::string kStillLife = "[display]\nwidth = 160\nheight = 90\n[scene]\nkind = still-life\n";

// Of four lamps that cast shadows one shines: the frame is that of this lamp alone.
TEST(Shadows, EveryLampCastsItsOwn) {
    const Exhibit all =
        exhibit_of(kStillLife + "[lamp.1]\nspectrum = D65\ndirection = 1 -1 0\nshadow = yes\n"
                                "[lamp.2]\nspectrum = D65\ndirection = -1 -1 -0.3\nshadow = yes\n"
                                "[lamp.3]\nspectrum = D65\nposition = -3 3 2\nshadow = yes\n"
                                "[lamp.4]\nspectrum = D65\ndirection = 0.2 -1 -1\nshadow = yes\n");
    for (std::size_t i = 0; i < 4; ++i) {
        Exhibit alone = all, dark_others = all;
        alone.lamps = {all.lamps[i]};
        for (std::size_t other = 0; other < 4; ++other)
            if (other != i)
                dark_others.lamps[other].strength = 0;
        const Image expected = frame_of(alone);
        EXPECT_EQ(pixels_apart(frame_of(dark_others), expected), 0) << "lamp " << i + 1;
        alone.lamps[0].shadow = false;
        EXPECT_GT(pixels_apart(frame_of(alone), expected), 150) << "lamp " << i + 1 << " casts a shadow";
    }
}

// Nothing stands between a convex body's lit faces and the lamp, up to its very edges.
TEST(Shadows, AConvexBodyHasNone) {
    for (const char* lamp : {"direction = 0 -0.5 -1\n", "direction = 0.3 -1 -1\n", "position = 0.5 2 4\n"}) {
        Exhibit exhibit =
            exhibit_of("[display]\nwidth = 640\nheight = 360\n[scene]\nkind = loaf\nmaterials = "
                       "cc-white\n[lamp.1]\nspectrum = D65\nshadow = yes\n" +
                       std::string(lamp));
        const Image shadowed = frame_of(exhibit);
        exhibit.lamps[0].shadow = false;
        EXPECT_EQ(pixels_apart(shadowed, frame_of(exhibit)), 0) << lamp;
    }
}

// A lamp amid the things sees a cone of 120 degrees; its light goes further.
TEST(Shadows, WhatTheMapDoesNotShowStandsInTheLight) {
    Exhibit exhibit =
        exhibit_of(kStillLife + "[lamp.1]\nspectrum = D65\nposition = 0 1.2 0.5\nshadow = yes\n");
    const Image shadowed = frame_of(exhibit);
    exhibit.lamps[0].shadow = false;
    const Image lit = frame_of(exhibit);
    for (int x = 0; x < 160; x += 8) { // the table's front, behind the cone
        EXPECT_LE(steps(pixel(shadowed, x, 88), pixel(lit, x, 88)), 1) << x;
        EXPECT_GT(pixel(lit, x, 88).g, 5) << x;
    }
}

} // namespace
} // namespace metamer
