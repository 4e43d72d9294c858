// One picture into another.
#include <gtest/gtest.h>

#include "kiosk/twin.h"

namespace metamer {
namespace {

TEST(Fade, HalfWayIsTheMean) {
    TestKiosk at;
    at.settle();
    const Exhibit old = lit(at.text, at.state());
    at.tap(Part::lamp, 1);
    const double began = at.stage.now_s();
    ASSERT_TRUE(at.kiosk.show().fading(began));
    const Exhibit fresh = lit(at.text, at.state());
    const Twin before(old), after(fresh);
    for (const double share : {0.0, 0.25, 0.5, 0.75}) {
        at.stage.advance(began + share * kFade_s - at.stage.now_s());
        at.turn();
        const double mixed = fade(share * kFade_s);
        const Seen8 seen(at);
        int far = 0;
        for (const Place& place : places(at)) {
            const EncodedRgb8 a = before.color(place.object, place.half),
                              b = after.color(place.object, place.half), shown = seen(place.x, place.y);
            const auto mean = [&](int from, int to) { return from + mixed * (to - from); };
            ASSERT_NEAR(shown.r, mean(a.r, b.r), 2.5) << share;
            ASSERT_NEAR(shown.g, mean(a.g, b.g), 2.5) << share;
            ASSERT_NEAR(shown.b, mean(a.b, b.b), 2.5) << share;
            far += apart(a, b) > 20;
        }
        EXPECT_GT(far, 0) << "else there is nothing to see";
    }
}

TEST(Fade, IsOverWithin300Ms) {
    TestKiosk at;
    at.settle();
    at.tap(Part::lamp, 0);
    const double began = at.stage.now_s();
    at.stage.advance(0.3);
    at.turn();
    EXPECT_FALSE(at.kiosk.show().fading(began + 0.3));
    const Exhibit fresh = lit(at.text, at.state());
    const Twin after(fresh);
    const Seen8 seen(at);
    for (const Place& place : places(at))
        ASSERT_LE(apart(seen(place.x, place.y), after.color(place.object, place.half)), 2);
    const long frames = at.stage.frames_shown();
    at.turn();
    EXPECT_EQ(at.stage.frames_shown(), frames) << "and nothing moves any more";
}

TEST(Fade, BeginsWithItsFirstFrame) {
    TestKiosk at;
    at.settle();
    const Exhibit old = lit(at.text, at.state());
    const Twin before(old);
    at.turn(DisplayGoneEvent{});
    at.tap(Part::lamp, 1);
    at.stage.advance(10); // as if planning and drawing had taken so long
    at.turn(DisplayBackEvent{});
    EXPECT_TRUE(at.kiosk.show().fading(at.stage.now_s()));
    const Seen8 seen(at);
    for (const Place& place : places(at))
        ASSERT_LE(apart(seen(place.x, place.y), before.color(place.object, place.half)), kMostSteps);
}

TEST(Fade, GoesOnFromTheMixtureWhereItIsBrokenOff) {
    TestKiosk at;
    at.settle();
    const Exhibit old = lit(at.text, at.state());
    at.tap(Part::lamp, 1);
    const Exhibit next = lit(at.text, at.state());
    const Twin from(old), to(next);
    at.stage.advance(0.5 * kFade_s);
    at.turn();
    at.tap(Part::lamp, 0);
    ASSERT_NE(at.state().lamp, 1u);
    const Seen8 seen(at);
    for (const Place& place : places(at)) {
        const EncodedRgb8 a = from.color(place.object, place.half), b = to.color(place.object, place.half),
                          shown = seen(place.x, place.y);
        ASSERT_NEAR(shown.r, (a.r + b.r) / 2.0, 2.5);
        ASSERT_NEAR(shown.g, (a.g + b.g) / 2.0, 2.5);
        ASSERT_NEAR(shown.b, (a.b + b.b) / 2.0, 2.5);
    }
}

TEST(Fade, StrengthFollowsTheFingerAtOnce) {
    TestKiosk at;
    at.settle();
    const PxBox slider = at.kiosk.desk().find(Part::strength)->box;
    at.turn(PointerEvent{PointerPhase::down, 0, slider.left + 0.3 * slider.width,
                         slider.top + slider.height / 2.0});
    EXPECT_FALSE(at.kiosk.show().fading(at.stage.now_s()));
}

TEST(Fade, BetweenModesTooAndBack) {
    TestKiosk at;
    at.settle();
    for (int i = 0; i < 2; ++i) {
        at.tap(Part::mode);
        EXPECT_TRUE(at.kiosk.show().fading(at.stage.now_s()));
        at.settle();
    }
    const Exhibit fresh = lit(at.text, at.state());
    const Twin after(fresh);
    const Seen8 seen(at);
    for (const Place& place : places(at))
        ASSERT_LE(apart(seen(place.x, place.y), after.color(place.object, place.half)), 2);
}

TEST(Fade, KeepsTheSplitWhereItWas) {
    TestKiosk at(patches("[tour.1]\nlamp = E\nsplit = 0.2\nseconds = 5\n"));
    at.settle();
    const Exhibit old = lit(at.text, at.state());
    const Twin before(old);
    const std::vector<Place> all = places(at);
    at.stage.advance(60);
    at.turn();
    ASSERT_EQ(at.kiosk.visit().phase(), Phase::tour);
    ASSERT_NEAR(at.state().split, 0.2, 1e-9);
    const Seen8 seen(at);
    int looked = 0;
    for (const Place& place : all) {
        // At its very beginning a fade is the old picture, with its halves where they were.
        bool hidden = false;
        for (const Widget& widget : at.kiosk.desk().widgets)
            hidden = hidden || widget.box.contains(place.x, place.y);
        const int column = static_cast<int>(0.2 * at.kiosk.desk().layout.scene.width);
        if (hidden || std::abs(place.x - column) < 6)
            continue;
        ASSERT_LE(apart(seen(place.x, place.y), before.color(place.object, place.half)), 2) << place.x;
        ++looked;
    }
    EXPECT_GT(looked, 100);
}

} // namespace
} // namespace metamer
