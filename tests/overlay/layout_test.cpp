#include "overlay/layout.h"

#include <gtest/gtest.h>

#include <cmath>
#include <ostream>
#include <string>

namespace metamer {
namespace {

struct Named {
    const char* name;
    int index;
    PxBox box;
    bool touchable, over_scene;
};

std::ostream& operator<<(std::ostream& out, const Named& named) {
    return out << named.name << ' ' << named.index << " (" << named.box.left << ", " << named.box.top << ", "
               << named.box.width << " x " << named.box.height << ")";
}

std::vector<Named> boxes_of(const Layout& layout, double split = 0.5) {
    std::vector<Named> all{{"left_label", 0, layout.left_label, false, false},
                           {"right_label", 0, layout.right_label, false, false},
                           {"strength", 0, layout.strength, true, false},
                           {"mode", 0, layout.mode, true, false},
                           {"expert", 0, layout.expert, true, false},
                           {"panel", 0, layout.panel, false, true},
                           {"next", 0, layout.next, true, true},
                           {"close", 0, layout.close, true, true},
                           {"expert_panel", 0, layout.expert_panel, false, true},
                           {"caption", 0, layout.caption, false, true},
                           {"hint", 0, layout.hint, false, true},
                           {"notice", 0, layout.notice, false, true},
                           {"split_handle", 0, split_handle(layout, split), true, true}};
    const auto add = [&](const char* name, const std::vector<PxBox>& boxes) {
        for (int index = 0; const PxBox& box : boxes)
            all.push_back({name, index++, box, true, false});
    };
    add("lamp", layout.lamps);
    add("lamp_right", layout.lamps_right);
    add("language", layout.languages);
    std::erase_if(all, [](const Named& named) { return named.box == PxBox{}; });
    return all;
}

bool overlap(const PxBox& a, const PxBox& b) {
    return a.left < b.right() && b.left < a.right() && a.top < b.bottom() && b.top < a.bottom();
}

bool inside(const PxBox& inner, const PxBox& outer) {
    return inner.left >= outer.left && inner.right() <= outer.right() && inner.top >= outer.top &&
           inner.bottom() <= outer.bottom();
}

const std::vector<ScreenSize>& screens() {
    static const std::vector<ScreenSize> all = [] {
        std::vector<ScreenSize> found;
        for (const auto& [a, b] : {std::pair{640, 480}, {800, 480}, {1280, 720}, {1920, 1080}, {320, 240}})
            for (const double px_per_mm : {0.0, 5.2})
                for (const auto& [width, height] : {std::pair{a, b}, {b, a}})
                    found.push_back({width, height, px_per_mm});
        for (const double px_per_mm : {1.6, 17.0, 1e6, -1.0, std::nan("")})
            found.push_back({1280, 720, px_per_mm});
        for (const double px_per_mm : {0.0, 4.0})
            found.push_back({4096, 4096, px_per_mm});
        found.push_back({4096, 1024, 0});
        found.push_back({1024, 4096, 0});
        return found;
    }();
    return all;
}

/// Bits 0 .. 6: booth, panel, expert, caption, hint, notice, right_to_left.
Contents contents_of(unsigned bits, int lamps, int languages) {
    const auto bit = [&](unsigned i) { return (bits >> i & 1u) != 0; };
    return {lamps, languages, bit(0), bit(1), bit(2), bit(3), bit(4), bit(5), bit(6)};
}

std::string said(const ScreenSize& s, unsigned bits, int lamps, int languages) {
    return std::to_string(s.width_px) + "x" + std::to_string(s.height_px) + " at " +
           std::to_string(s.px_per_mm) + ", contents " + std::to_string(bits) + ", " + std::to_string(lamps) +
           " lamps, " + std::to_string(languages) + " languages";
}

template <class Check>
void for_all(Check check) {
    for (const ScreenSize& screen : screens())
        for (unsigned bits = 0; bits < 128; ++bits)
            for (const auto& [lamps, languages] : {std::pair{12, 6}, {7, 2}, {0, 1}, {1, 12}}) {
                const Contents contents = contents_of(bits, lamps, languages);
                check(screen, contents, lay_out(screen, contents));
                if (testing::Test::HasFailure())
                    FAIL() << said(screen, bits, lamps, languages);
            }
}

TEST(Layout, KeepsEveryBoxInsideTheScreenAndApart) {
    for_all([](const ScreenSize& screen, const Contents& contents, const Layout& layout) {
        const PxBox whole{0, 0, screen.width_px, screen.height_px};
        const std::vector<Named> all = boxes_of(layout, contents.right_to_left ? 0.0 : 0.97);
        // Tens of millions of pairs: only what is wrong is told to GoogleTest.
        for (std::size_t i = 0; i < all.size(); ++i) {
            const Named& one = all[i];
            if (one.box.width <= 0 || one.box.height <= 0 || !inside(one.box, whole))
                ADD_FAILURE() << one << " is not inside the screen";
            if (one.over_scene ? !inside(one.box, layout.scene) : overlap(one.box, layout.scene))
                ADD_FAILURE() << one << " is on the wrong side of the scene's edge";
            for (std::size_t j = 0; j < i; ++j)
                if (overlap(one.box, all[j].box) &&
                    !(all[j].box == layout.panel && (one.box == layout.close || one.box == layout.next)))
                    ADD_FAILURE() << one << " overlaps " << all[j];
        }
    });
}

TEST(Layout, PutsLabelsAboveTheSceneEachOverItsHalf) {
    for_all([](const ScreenSize& screen, const Contents&, const Layout& layout) {
        EXPECT_LE(layout.left_label.bottom(), layout.scene.top);
        EXPECT_LE(layout.right_label.bottom(), layout.scene.top);
        EXPECT_LE(layout.left_label.right(), screen.width_px / 2);
        EXPECT_GE(layout.right_label.left, screen.width_px / 2);
        EXPECT_EQ(layout.scene.left, 0);
        EXPECT_NEAR(layout.scene.width, screen.width_px, 1);
    });
}

TEST(Layout, KeepsWhatIsTouchedInTheLowerHalf) {
    for_all([](const ScreenSize& screen, const Contents&, const Layout& layout) {
        for (const Named& one : boxes_of(layout)) {
            if (one.touchable && one.box.top < screen.height_px / 2 - 1)
                ADD_FAILURE() << one << " begins above the middle";
        }
    });
}

TEST(Layout, HasWhatThereIsAndNothingElse) {
    for_all([](const ScreenSize&, const Contents& contents, const Layout& layout) {
        const auto there = [](const PxBox& box) { return !(box == PxBox{}); };
        EXPECT_EQ(layout.lamps.size(), static_cast<std::size_t>(contents.lamps));
        EXPECT_EQ(layout.lamps_right.size(), contents.booth ? layout.lamps.size() : 0u);
        EXPECT_EQ(layout.languages.size(),
                  contents.languages > 1 ? static_cast<std::size_t>(contents.languages) : 0u);
        EXPECT_EQ(there(layout.mode), contents.lamps > 1);
        EXPECT_EQ(there(layout.panel), contents.panel);
        EXPECT_EQ(there(layout.close) && there(layout.next), contents.panel);
        EXPECT_EQ(there(layout.expert_panel), contents.expert);
        EXPECT_EQ(there(layout.notice), contents.notice);
        EXPECT_EQ(there(layout.hint), contents.hint && !contents.panel);
        EXPECT_EQ(there(layout.caption), contents.caption && !contents.panel);
        EXPECT_EQ(there(split_handle(layout, 0.5)), !contents.panel);
        EXPECT_TRUE(there(layout.strength) && there(layout.expert) && there(layout.left_label) &&
                    there(layout.right_label));
    });
}

TEST(Layout, PutsCloseWhereThePanelLeavesRoomForIt) {
    for_all([](const ScreenSize&, const Contents& contents, const Layout& layout) {
        if (!contents.panel)
            return;
        const double inset = kCloseInset * layout.unit_px;
        EXPECT_TRUE(inside(layout.close, layout.panel) && inside(layout.next, layout.panel));
        EXPECT_NEAR(layout.next.width, kNextWidth * layout.unit_px, 1);
        EXPECT_NEAR(layout.close.width, kCloseWidth * layout.unit_px, 1);
        EXPECT_NEAR(layout.close.height, kCloseHeight * layout.unit_px, 1);
        EXPECT_NEAR(layout.panel.bottom() - layout.close.bottom(), inset, 1);
        EXPECT_NEAR(contents.right_to_left ? layout.close.left - layout.panel.left
                                           : layout.panel.right() - layout.close.right(),
                    inset, 1);
    });
}

TEST(Layout, MirrorsControlsButNotHalves) {
    for_all([](const ScreenSize& screen, const Contents& contents, const Layout& layout) {
        Contents other = contents;
        other.right_to_left = !contents.right_to_left;
        const Layout mirrored = lay_out(screen, other);
        const auto turned = [&](PxBox box) {
            if (box.width > 0)
                box.left = screen.width_px - box.right();
            return box;
        };
        EXPECT_EQ(mirrored.left_label, layout.left_label);
        EXPECT_EQ(mirrored.right_label, layout.right_label);
        EXPECT_EQ(mirrored.scene, layout.scene);
        EXPECT_EQ(mirrored.strength, turned(layout.strength));
        EXPECT_EQ(mirrored.expert_panel, turned(layout.expert_panel));
        EXPECT_EQ(mirrored.panel, turned(layout.panel));
        EXPECT_EQ(mirrored.notice, turned(layout.notice));
        for (std::size_t i = 0; i < layout.lamps.size(); ++i)
            EXPECT_EQ(mirrored.lamps[i], turned(contents.booth ? layout.lamps_right[i] : layout.lamps[i]));
        if (contents.booth) {
            for (const PxBox& box : layout.lamps)
                EXPECT_LE(box.right(), screen.width_px / 2);
            for (const PxBox& box : layout.lamps_right)
                EXPECT_GE(box.left, screen.width_px / 2);
        }
    });
}

TEST(Layout, LeavesControlsWhereTheyAreWhateverLiesOverTheScene) {
    for_all([](const ScreenSize& screen, const Contents& contents, const Layout& layout) {
        Contents bare = contents;
        bare.panel = bare.expert = bare.caption = bare.hint = bare.notice = false;
        const Layout other = lay_out(screen, bare);
        EXPECT_EQ(other.scene, layout.scene);
        EXPECT_EQ(other.lamps, layout.lamps);
        EXPECT_EQ(other.strength, layout.strength);
        EXPECT_EQ(other.languages, layout.languages);
    });
}

TEST(Layout, GivesAFingerTwelveMillimetersWhereTheScreenAllows) {
    for (const auto& [screen, lamps] : {std::pair{ScreenSize{800, 480, 5.2}, 12},
                                        {ScreenSize{480, 800, 5.2}, 9},
                                        {ScreenSize{1280, 720, 5.7}, 12},
                                        {ScreenSize{1920, 1080, 8.6}, 12},
                                        {ScreenSize{640, 480, 0}, 12}})
        for (const bool booth : {false, true}) {
            Contents contents;
            contents.lamps = lamps;
            contents.languages = 6;
            contents.booth = booth;
            const double px_per_mm = screen.px_per_mm > 0 ? screen.px_per_mm : 800 / (10.1 * 25.4);
            for (const PxBox& tile : lay_out(screen, contents).lamps) {
                EXPECT_GE(tile.width, 12 * px_per_mm - 1) << screen.width_px << " booth " << booth;
                EXPECT_GE(tile.height, 12 * px_per_mm - 1) << screen.width_px << " booth " << booth;
            }
        }
}

TEST(Layout, KeepsMillimetersWhereTheScreenHasRoomAndShrinksWhereNot) {
    Contents contents;
    contents.lamps = 12;
    contents.languages = 6;
    EXPECT_EQ(lay_out({1280, 720, 5.7}, contents).unit_px, 5.7);
    EXPECT_EQ(lay_out({1920, 1080, 8.6}, contents).unit_px, 8.6);
    EXPECT_LT(lay_out({320, 240, 5.2}, contents).unit_px, 4);
    // A television has few pixels to the millimeter: letters must have some all the same.
    EXPECT_GT(lay_out({1920, 1080, 1.6}, contents).unit_px, 6);
    // Unknown: 10.1 inches, 1469 px over 256.54 mm.
    EXPECT_NEAR(lay_out({1280, 720, 0}, contents).unit_px, 5.725, 0.01);
}

TEST(SplitHandle, StandsOnTheSplitInsideTheScene) {
    Contents contents;
    contents.lamps = 6;
    const Layout layout = lay_out({1280, 720, 5.7}, contents);
    const PxBox middle = split_handle(layout, 0.5);
    EXPECT_NEAR(middle.left + middle.width / 2.0, 640, 1);
    EXPECT_NEAR(middle.width, 12 * 5.7, 1);
    EXPECT_EQ(split_handle(layout, 0).left, 0);
    EXPECT_EQ(split_handle(layout, 1).right(), 1280);
    EXPECT_EQ(split_handle(layout, -3), split_handle(layout, 0));
}

TEST(SliderValue, GoesWithTheTrackEitherWay) {
    const PxBox slider{100, 500, 300, 60};
    const PxBox track = slider_track(slider, 5);
    EXPECT_TRUE(inside(track, slider));
    EXPECT_EQ(slider_value(slider, 5, false, track.left), 0);
    EXPECT_EQ(slider_value(slider, 5, false, track.right()), 1);
    EXPECT_EQ(slider_value(slider, 5, true, track.left), 1);
    EXPECT_EQ(slider_value(slider, 5, true, track.right()), 0);
    EXPECT_NEAR(slider_value(slider, 5, false, track.left + 0.25 * track.width), 0.25, 1e-12);
    EXPECT_EQ(slider_value(slider, 5, false, 0), 0);
    EXPECT_EQ(slider_value(slider, 5, false, 5000), 1);
}

} // namespace
} // namespace metamer
