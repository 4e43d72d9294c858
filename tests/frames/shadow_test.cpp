// Shadow maps: what a lamp's view is, that lamps add up, and that nothing round shadows itself.
#include "render/shadow_maps.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "frames/frames.h"
#include "render/scene.h"

namespace metamer {
namespace {

float depth_of(const ShadowTile& tile, const glm::vec3& point) {
    return glm::dot(tile.depth_from_world, glm::vec4(point, 1));
}

TEST(ShadowView, DepthIsLinearAlongTheAxis) {
    const glm::vec3 center(0, 0.6f, 0);
    for (const glm::vec4& place : {glm::vec4(3, 4.6f, 0, 1), glm::vec4(0.6f, 0.8f, 0, 0)}) {
        const ShadowTile tile = shadow_view(place, center, 2);
        const glm::vec3 axis = place.w == 0 ? -glm::vec3(place) : glm::normalize(center - glm::vec3(place));
        EXPECT_NEAR(depth_of(tile, center), 0.5, 1e-5);
        EXPECT_NEAR(depth_of(tile, center - 2.0f * axis), 0, 1e-5) << "where the sphere begins";
        EXPECT_NEAR(depth_of(tile, center + 2.0f * axis), 1, 1e-5) << "where it ends";
        const glm::vec4 clip = tile.shadow_from_world * glm::vec4(center, 1);
        EXPECT_NEAR(clip.x / clip.w, 0, 1e-5);
        EXPECT_NEAR(clip.y / clip.w, 0, 1e-5);
    }
}

TEST(ShadowView, IsFiniteForALampAnywhere) {
    const glm::vec3 center(0, 0.6f, 0);
    for (const glm::vec4& place : {glm::vec4(center, 1), glm::vec4(0, 5, 0, 1), glm::vec4(0, -5, 0, 1),
                                   glm::vec4(0, 1, 0, 0), glm::vec4(100, 100, 100, 1)}) {
        const ShadowTile tile = shadow_view(place, center, 2.4f);
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 4; ++row)
                EXPECT_TRUE(std::isfinite(tile.shadow_from_world[column][row]));
        EXPECT_TRUE(std::isfinite(depth_of(tile, {1, 1, 1})));
    }
}

std::string still_life(const std::string& lamps) {
    return "[display]\nwidth = 320\nheight = 180\ntransfer = none\n[accuracy]\nmethod = rgb\n[scene]\nkind = "
           "still-life\n" +
           lamps;
}

// Light adds up: four lamps with their shadows are the four frames of one lamp each, summed before the curve.
TEST(Shadows, OfFourLampsAreThoseOfEach) {
    const char* const kPlaces[] = {"direction = 1 -1 -0.5", "direction = -1 -1 -0.5", "position = 0 4 2",
                                   "position = -3 2 3\nfalloff = 1 0 0.05"};
    std::string all;
    std::vector<Image> single;
    for (int i = 0; i < 4; ++i) {
        const std::string lamp = "\nspectrum = F" + std::to_string(i + 1) +
                                 "\nstrength = 0.22\nshadow = yes\n" + kPlaces[i] + "\n";
        all += "[lamp." + std::to_string(i + 1) + "]" + lamp;
        single.push_back(frame_of(exhibit_of(still_life("[lamp.1]" + lamp))));
    }
    const Image together = frame_of(exhibit_of(still_life(all)));
    int off = 0;
    for (int y = 0; y < 180; ++y)
        for (int x = 0; x < 320; ++x) {
            int sum = 0;
            for (const Image& image : single)
                sum += pixel(image, x, y).g;
            if (pixel(single[0], x, y) != EncodedRgb8{43, 43, 43}) // the background is not lit
                off += sum < 250 && std::abs(sum - pixel(together, x, y).g) > 3;
        }
    EXPECT_LT(off, 20) << "but for a few pixels on edges";
}

TEST(Shadows, NothingRoundShadowsItself) {
    const std::string grazing = "[lamp.1]\nspectrum = E\nstrength = 0.9\ndirection = 0.5 -1 -0.9\n";
    const Image without = frame_of(exhibit_of(still_life(grazing)));
    const Exhibit exhibit = exhibit_of(still_life(grazing + "shadow = yes\n"));
    const Image with = frame_of(exhibit);
    // The ball: center (-1.35, 0.55, 0.05), radius 0.55; nothing stands between it and this lamp.
    const View view = view_of(build_scene(exhibit).camera, 320.0 / 180);
    const glm::vec4 clip = view.clip_from_world * glm::vec4(-1.35f, 0.55f, 0.05f, 1);
    const float cx = (clip.x / clip.w + 1) * 160, cy = (1 - clip.y / clip.w) * 90, radius_px = 36;
    int lit = 0, off = 0;
    for (int y = 0; y < 180; ++y)
        for (int x = 0; x < 320; ++x)
            if (std::hypot(static_cast<float>(x) - cx, static_cast<float>(y) - cy) < radius_px) {
                lit += pixel(without, x, y).g > 20;
                off += steps(pixel(with, x, y), pixel(without, x, y)) > 1;
            }
    EXPECT_GT(lit, 1500) << "this is the ball";
    EXPECT_EQ(off, 0);
}

/// How many pixels of two frames are more than a step apart.
int pixels_apart(const Image& a, const Image& b) {
    int apart = 0;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x)
            apart += steps(pixel(a, x, y), pixel(b, x, y)) > 1;
    return apart;
}

const std::string kStillLife = "[display]\nwidth = 160\nheight = 90\n[scene]\nkind = still-life\n";

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

// One lamp, one sample a pixel: whatever is neither lit nor dark is the filter's work.
TEST(Shadows, EdgesAreFiltered) {
    Exhibit exhibit = exhibit_of(still_life("[lamp.1]\nspectrum = E\nposition = -1 1.6 1.5\nshadow = yes\n"));
    for (ObjectSetting& object : exhibit.objects)
        object.specular = 0;
    const Image shadowed = frame_of(exhibit);
    exhibit.lamps[0].shadow = false;
    const Image lit = frame_of(exhibit);
    int dark = 0, between = 0;
    for (int y = 0; y < 180; ++y)
        for (int x = 0; x < 320; ++x) {
            const int all = pixel(lit, x, y).g, left = pixel(shadowed, x, y).g;
            dark += all > 60 && left == 0;
            between += all > 60 && left > all / 5 && left < all * 4 / 5;
        }
    EXPECT_GT(dark, 500);
    EXPECT_GT(between, 50);
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
