// The light booth: all of it in each half, and two cards that tell the lamps apart.
#include <gtest/gtest.h>
#include <set>

#include "frames/frames.h"
#include "render/pick.h"

namespace metamer {
namespace {

Exhibit booth(const std::string& more = "") {
    return exhibit_of("[display]\nwidth = 320\nheight = 180\n[scene]\nkind = booth\n" + more);
}

// Where an object is seen in a half: the middle of all points that hit it, as shares of the half.
glm::dvec2 middle_of(const Exhibit& exhibit, const Scene& scene, const std::string& name, double aspect) {
    glm::dvec2 sum(0);
    int hits = 0;
    for (double x = 0.01; x < 1; x += 0.02)
        for (double y = 0.01; y < 1; y += 0.02)
            if (const auto hit = pick(scene, exhibit, x, y, aspect);
                hit && exhibit.objects[hit->object].name == name) {
                sum += glm::dvec2(x, y);
                ++hits;
            }
    EXPECT_GT(hits, 0) << name;
    return sum / static_cast<double>(std::max(hits, 1));
}

TEST(Booth, TheCardsMatchOnTheLeftAndPartOnTheRight) {
    const Exhibit exhibit = booth("[compare]\nleft.lamp = D65\nright.lamp = F11\n");
    const Scene scene = build_scene(exhibit);
    const Image frame = frame_of(exhibit);
    const double aspect = 160.0 / 180;
    const glm::dvec2 a = middle_of(exhibit, scene, "card-a", aspect),
                     b = middle_of(exhibit, scene, "card-b", aspect);
    const auto seen = [&](const glm::dvec2& at, int half) {
        return pixel(frame, 160 * half + static_cast<int>(at.x * 160), static_cast<int>(at.y * 180));
    };
    EXPECT_LE(steps(seen(a, 0), seen(b, 0)), 1) << text_of(seen(a, 0)) << ", " << text_of(seen(b, 0));
    EXPECT_GT(steps(seen(a, 1), seen(b, 1)), 100) << text_of(seen(a, 1)) << ", " << text_of(seen(b, 1));
    EXPECT_GT(seen(a, 0).g, 60) << "lit";
}

TEST(Booth, TheCardsTouch) {
    const Exhibit exhibit = booth("[compare]\nleft.lamp = D65\nright.lamp = F11\n");
    const Image frame = frame_of(exhibit);
    const glm::dvec2 a = middle_of(exhibit, build_scene(exhibit), "card-a", 160.0 / 180);
    const int y = static_cast<int>(a.y * 180);
    // From one card to the other in the left half: one color all the way.
    for (int x = static_cast<int>(a.x * 160); x < 160 - static_cast<int>(a.x * 160); ++x)
        EXPECT_LE(steps(pixel(frame, x, y), pixel(frame, 80, y)), 1) << x;
}

TEST(Booth, EachHalfShowsAllOfIt) {
    const Exhibit same = booth("[compare]\nleft.lamp = D65\nright.lamp = D65\n"), whole = [] {
        Exhibit half = booth();
        half.display.width_px = 160;
        return half;
    }();
    const Image halves = frame_of(same), one = frame_of(whole);
    // Only the cards differ: they are made for these lamps.
    int different = 0;
    for (int y = 0; y < 180; ++y)
        for (int x = 0; x < 160; ++x) {
            EXPECT_EQ(pixel(halves, x, y), pixel(halves, x + 160, y)) << x << ' ' << y;
            different += steps(pixel(halves, x, y), pixel(one, x, y)) > 1;
        }
    EXPECT_LT(different, 160 * 180 / 3);
}

TEST(Booth, FillsFramesOfAnyShapeAndHidesNoCard) {
    for (const char* materials :
         {"cc-red", "cc-red, cc-green, cc-blue, cc-cyan, cc-yellow",
          "crayon-white, crayon-gray, crayon-red, crayon-blue, crayon-green, "
          "crayon-black, crayon-brown, cc-red, cc-green, cc-blue, cc-cyan, cc-yellow"}) {
        const Exhibit exhibit = booth("materials = " + std::string(materials) + "\n");
        const Scene scene = build_scene(exhibit);
        for (const double aspect : {0.25, 0.5, 8.0 / 9, 4.0 / 3, 16.0 / 9, 3.0}) {
            std::set<std::size_t> seen;
            for (double x = 0.005; x < 1; x += 0.01)
                for (double y = 0.0025; y < 1; y += 0.005) {
                    const auto hit = pick(scene, exhibit, x, y, aspect);
                    ASSERT_TRUE(hit) << "a hole at " << x << ' ' << y << ", aspect " << aspect;
                    seen.insert(hit->object);
                    // The frame's rim shows the room, not half a card.
                    if (x < 0.01 || x > 0.99 || y < 0.005 || y > 0.995) {
                        EXPECT_EQ(exhibit.objects[hit->object].name, "interior") << aspect;
                    }
                }
            EXPECT_EQ(seen.size(), exhibit.objects.size()) << aspect << ' ' << materials;
        }
    }
}

} // namespace
} // namespace metamer
