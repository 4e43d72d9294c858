#include "render/pick.h"

#include <gtest/gtest.h>
#include <set>

#include "frames/frames.h"

namespace metamer {
namespace {

constexpr int kWidth = 64, kHeight = 48;

// One of seven colors that stay apart in any light: which of red, green and blue they have, 1 .. 7.
std::string code_color(std::size_t bits) {
    std::string code = "rgb:";
    for (const std::size_t bit : {4u, 2u, 1u})
        code += bits & bit ? "FF" : "00";
    return code;
}

// 0 where it is too dark to tell.
std::size_t bits_of(const EncodedRgb8& c) {
    const int most = std::max({c.r, c.g, c.b});
    if (most < 60)
        return 0;
    return 4u * (c.r > most / 2) + 2u * (c.g > most / 2) + 1u * (c.b > most / 2);
}

std::string frame_text(const std::string& kind) {
    return "[display]\nwidth = " + std::to_string(kWidth) + "\nheight = " + std::to_string(kHeight) +
           "\n[scene]\nkind = " + kind + "\n";
}

// The same scene, object i in the color of the digit i / place % 7.
Exhibit coded(const std::string& kind, std::size_t place) {
    const Exhibit plain = exhibit_of(frame_text(kind));
    std::string text = frame_text(kind);
    for (std::size_t i = 0; i < plain.objects.size(); ++i)
        text += "[object." + plain.objects[i].name +
                "]\nspecular = 0\nmaterial = " + code_color(i / place % 7 + 1) + "\n";
    return exhibit_of(text);
}

std::optional<Hit> pick_pixel(const Scene& scene, const Exhibit& exhibit, int x, int y) {
    return pick(scene, exhibit, (x + 0.5) / kWidth, (y + 0.5) / kHeight,
                static_cast<double>(kWidth) / kHeight);
}

using Hits = std::vector<std::optional<Hit>>;

Hits all_hits(const std::string& kind) {
    const Exhibit exhibit = exhibit_of(frame_text(kind));
    const Scene scene = build_scene(exhibit);
    Hits hits;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x)
            hits.push_back(pick_pixel(scene, exhibit, x, y));
    return hits;
}

// What is drawn is what is hit: at every lit pixel the color of the object, to a pixel at silhouettes.
void expect_colors_of_picks(const std::string& kind, std::size_t place, const Hits& hits) {
    const Image frame = frame_of(coded(kind, place));
    const auto hit_at = [&](int x, int y) { return hits[static_cast<std::size_t>(y * kWidth + x)]; };
    const auto agrees = [&](int x, int y, const EncodedRgb8& drawn) {
        const auto hit = hit_at(x, y);
        return hit ? bits_of(drawn) == hit->object / place % 7 + 1 : drawn.r == drawn.g && drawn.g == drawn.b;
    };
    int lit = 0;
    for (int y = 1; y + 1 < kHeight; ++y)
        for (int x = 1; x + 1 < kWidth; ++x) {
            const EncodedRgb8 drawn = pixel(frame, x, y);
            if (hit_at(x, y) && bits_of(drawn) == 0)
                continue;
            lit += hit_at(x, y).has_value();
            EXPECT_TRUE(agrees(x, y, drawn) || agrees(x - 1, y, drawn) || agrees(x + 1, y, drawn) ||
                        agrees(x, y - 1, drawn) || agrees(x, y + 1, drawn))
                << kind << " at " << x << ", " << y << ": " << text_of(drawn);
        }
    EXPECT_GT(lit, kWidth * kHeight / 5) << kind;
}

TEST(Pick, HitsWhatIsDrawnThere) {
    for (const char* kind : {"loaf", "crayons", "patches", "still-life", "booth"}) {
        const Hits hits = all_hits(kind);
        std::set<std::size_t> seen;
        for (const auto& hit : hits)
            if (hit)
                seen.insert(hit->object);
        EXPECT_EQ(seen.size(), exhibit_of(frame_text(kind)).objects.size()) << kind;
        for (const std::size_t place : {1u, 7u})
            expect_colors_of_picks(kind, place, hits);
    }
}

TEST(Pick, HitsNothingInTheBackground) {
    const Exhibit exhibit = exhibit_of(frame_text("loaf"));
    const Scene scene = build_scene(exhibit);
    EXPECT_FALSE(pick(scene, exhibit, 0.02, 0.5, 2));
    EXPECT_FALSE(pick(scene, exhibit, 0.98, 0.02, 2));
    EXPECT_TRUE(pick(scene, exhibit, 0.5, 0.5, 2));
}

TEST(Pick, FlatScenesHaveTheirPlacesAndTextures) {
    const Exhibit ramp = exhibit_of(frame_text("ramp"));
    const Scene scene = build_scene(ramp);
    for (std::size_t i = 0; i < 3; ++i) {
        const auto hit = pick(scene, ramp, 0.25, (static_cast<double>(i) + 0.5) / 3, 3);
        ASSERT_TRUE(hit);
        EXPECT_EQ(hit->object, i);
        EXPECT_NEAR(hit->u, 0.25, 1e-6);
        EXPECT_NEAR(hit->v, 0.5, 1e-6);
    }
    EXPECT_FALSE(pick(scene, ramp, 0.5, 1.0 / 3, 3)) << "between two bars";
}

TEST(Pick, GlassIsBeforeItsBoard) {
    const Exhibit media = exhibit_of(frame_text("media"));
    const Scene scene = build_scene(media);
    const auto name = [&](double x, double y) {
        return media.objects[pick(scene, media, x, y, 1.5)->object].name;
    };
    EXPECT_EQ(name(0.5, 0.3), "wedge");
    EXPECT_EQ(name(0.5, 0.8), "vessel");
    EXPECT_EQ(name(0.05, 0.8), "board");
}

// Each of the ball's panels is of the material that the map says.
TEST(Pick, KnowsTheMaterialByTheKeyMap) {
    std::string text = frame_text("still-life") + "materials = ";
    for (std::size_t bits = 1; bits <= 7; ++bits)
        text += code_color(bits) + ", ";
    text += "rgb:808080\n[object.ball]\nkey_map = maps/beach-ball.png\nspecular = 0\n";
    const Exhibit exhibit = exhibit_of(text);
    const Scene scene = build_scene(exhibit);
    const Image frame = frame_of(exhibit);
    std::set<int> keys;
    int wrong = 0, all = 0;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const auto hit = pick_pixel(scene, exhibit, x, y);
            if (!hit || exhibit.objects[hit->object].name != "ball" || bits_of(pixel(frame, x, y)) == 0)
                continue;
            const int key = material_key(exhibit, *hit);
            keys.insert(key);
            ++all;
            wrong += bits_of(pixel(frame, x, y)) != static_cast<std::size_t>(std::min(key, 7));
        }
    EXPECT_GT(all, 50);
    EXPECT_GE(keys.size(), 4u);
    EXPECT_LT(wrong, all / 8) << "along edges of panels alone";
    const auto table = std::ranges::find(exhibit.objects, "table", &ObjectSetting::name);
    const Hit on_table{static_cast<std::size_t>(table - exhibit.objects.begin())};
    EXPECT_EQ(material_key(exhibit, on_table), table->material.key);
}

} // namespace
} // namespace metamer
