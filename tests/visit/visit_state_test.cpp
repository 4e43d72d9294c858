#include "visit/visit_state.h"

#include <cmath>
#include <gtest/gtest.h>

#include "visit/visits.h"

namespace metamer {
namespace {

TEST(StartState, IsTheExhibitsOwn) {
    const Exhibit exhibit = visited();
    const VisitState state = start_state(exhibit);
    EXPECT_EQ(state.mode, Mode::methods);
    EXPECT_FALSE(state.lamp) << "its two lamps differ";
    EXPECT_EQ(state.strength, 1);
    EXPECT_EQ(state.split, 0.25);
    EXPECT_FALSE(state.seen);
    EXPECT_EQ(state.language, "en");
    EXPECT_EQ(state.booth_left, 1u);
    EXPECT_EQ(state.booth_right, 3u);
    Exhibit one = exhibit;
    one.lamps.resize(1);
    EXPECT_EQ(start_state(one).lamp, 3u) << "F11 stands on the shelf";
}

TEST(StartState, TakesTheSplitInAnyUnit) {
    Exhibit exhibit = visited();
    exhibit.compare->split_px = 320;
    EXPECT_EQ(split_share(exhibit), 0.25);
    exhibit.compare->split_px = 5000;
    EXPECT_EQ(split_share(exhibit), 1);
    exhibit.compare.reset();
    EXPECT_EQ(split_share(exhibit), 0);
}

TEST(Strength, OneIsTheMiddleOfTheSlider) {
    EXPECT_NEAR(slider_of_strength(1), 0.5, 1e-12);
    EXPECT_EQ(slider_of_strength(kLeastStrength), 0);
    EXPECT_EQ(slider_of_strength(kMostStrength), 1);
    EXPECT_EQ(slider_of_strength(1e9), 1);
    for (const double strength : {0.05, 0.3, 1.0, 7.0, 20.0})
        EXPECT_NEAR(strength_of_slider(slider_of_strength(strength)), strength, 1e-12 * strength);
    EXPECT_NEAR(strength_of_slider(2), kMostStrength, 1e-12);
}

TEST(Apply, ChangesEveryLampsSpectrumAndScalesItsStrength) {
    const Exhibit exhibit = visited();
    Exhibit drawn = exhibit;
    VisitState state = start_state(exhibit);
    state.lamp = 2;
    state.strength = 4;
    apply(state, exhibit, drawn);
    for (const LampSetting& lamp : drawn.lamps) {
        EXPECT_EQ(lamp.lamp.name, "A2800");
        EXPECT_EQ(lamp.key, exhibit.kiosk.lamps[2].key);
    }
    EXPECT_EQ(drawn.lamps[0].strength, 8);
    EXPECT_EQ(drawn.lamps[1].strength, 2);
    apply(start_state(exhibit), exhibit, drawn);
    EXPECT_EQ(drawn.lamps[0].lamp.name, "F11") << "and back";
    EXPECT_EQ(drawn.lamps[1].lamp.name, "E");
    EXPECT_EQ(drawn.lamps[0].strength, 2);
}

TEST(Apply, ScalesWhatHalvesHaveInsteadToo) {
    Exhibit exhibit = visited();
    exhibit.compare = Compare();
    exhibit.compare->right.strength = 3;
    Exhibit drawn = exhibit;
    VisitState state = start_state(exhibit);
    for (const double factor : {4.0, 0.5}) {
        state.strength = factor;
        apply(state, exhibit, drawn);
        EXPECT_EQ(drawn.compare->right.strength, 3 * factor);
        EXPECT_FALSE(drawn.compare->left.strength);
    }
}

} // namespace
} // namespace metamer
