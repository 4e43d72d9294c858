// A kiosk through its days: what it draws, and that it draws nothing while nothing changes.
#include "kiosk/kiosk.h"

#include <gmock/gmock.h>

#include "base/error.h"
#include "kiosk/twin.h"

namespace metamer {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const char* const kTour = "[tour.1]\nlamp = E\ncaption = One\nseconds = 5\n"
                          "[tour.2]\nlamp = D65\nsplit = 0.25\ncaption = Two\nseconds = 5\n"
                          "[tour.3]\nmaterials = cc-cyan, crayon-white\ncaption = Three\nseconds = 5\n";

bool dark(const TestKiosk& at) {
    const std::vector<std::uint8_t> rgba = at.stage.read_rgba();
    for (std::size_t i = 0; i < rgba.size(); ++i)
        if (rgba[i] != (i % 4 == 3 ? 255 : 0))
            return false;
    return true;
}

TEST(Kiosk, ShowsItsFirstFrameAndSaysSo) {
    TestKiosk at;
    EXPECT_EQ(at.stage.frames_shown(), 1);
    EXPECT_EQ(at.loads, 1);
    EXPECT_THAT(at.lines, ElementsAre(testing::StartsWith("event=shown driver=surfaceless renderer=")));
    EXPECT_THAT(at.described, HasSubstr("\"mode\": \"methods\""));
    expect_colors(at, lit(at.text, at.state()));
}

TEST(Kiosk, WakesForWhatTheLogKeptBack) {
    TestKiosk at(patches("idle_s = 3600\n"));
    std::vector<std::string> lines;
    Log log([&](std::string_view line) { lines.emplace_back(line); },
            [&] {
                return std::chrono::steady_clock::time_point(
                    std::chrono::seconds(std::lround(at.stage.now_s())));
            },
            false);
    KioskParts parts = at.parts();
    parts.log = &log;
    Kiosk kiosk(std::move(parts));
    log.write(Priority::info, "a", {{"n", "1"}});
    log.write(Priority::info, "a", {{"n", "2"}});
    const double since_s = at.stage.now_s();
    kiosk.turn();
    EXPECT_EQ(at.stage.now_s(), since_s + 60);
    EXPECT_EQ(lines.back(), "event=a n=2 late_s=60");
}

TEST(Kiosk, DrawsNothingWhileNothingChanges) {
    TestKiosk at(patches("night = 20:00-08:00\nidle_s = 3600\n"));
    at.settle();
    const long frames = at.stage.frames_shown(), paintings = at.kiosk.show().overlay().paintings();
    at.pass(3599);
    EXPECT_EQ(at.stage.frames_shown(), frames);
    EXPECT_EQ(at.kiosk.show().overlay().paintings(), paintings);
}

TEST(Kiosk, IdleWithoutATourItStandsStill) {
    TestKiosk at;
    at.pass(61);
    EXPECT_EQ(at.kiosk.visit().phase(), Phase::tour);
    const long frames = at.stage.frames_shown();
    at.pass(3600);
    EXPECT_EQ(at.stage.frames_shown(), frames);
}

TEST(Kiosk, DrawsAgainOnlyWhatWasLost) {
    TestKiosk at;
    const long frames = at.stage.frames_shown();
    at.turn(ExposeEvent{});
    EXPECT_EQ(at.stage.frames_shown(), frames + 1);
    at.turn(KeyEvent{Key::escape});
    EXPECT_EQ(at.stage.frames_shown(), frames + 1) << "a key that means nothing";
    at.turn(PointerEvent{PointerPhase::move, 5, 10, 10});
    EXPECT_EQ(at.stage.frames_shown(), frames + 1);
}

TEST(Kiosk, PaintsOnlyWhatLooksDifferent) {
    TestKiosk at;
    at.settle();
    const long before = at.kiosk.show().overlay().paintings();
    at.tap(Part::lamp, 1);
    EXPECT_EQ(at.kiosk.show().overlay().paintings(), before + 2) << "the tile that was, the tile that is";
}

TEST(Kiosk, ADragOfTheSplitPaintsNothing) {
    TestKiosk at;
    at.settle();
    const PxBox handle = at.kiosk.desk().find(Part::split)->box;
    const double x = handle.left + 5, y = handle.top + 5;
    at.turn(PointerEvent{PointerPhase::down, 0, x, y});
    const long frames = at.stage.frames_shown(), paintings = at.kiosk.show().overlay().paintings();
    for (int i = 1; i <= 20; ++i)
        at.turn(PointerEvent{PointerPhase::move, 0, x + 4 * i, y});
    EXPECT_EQ(at.stage.frames_shown(), frames + 20);
    EXPECT_EQ(at.kiosk.show().overlay().paintings(), paintings);
    EXPECT_EQ(at.kiosk.desk().find(Part::split)->value, at.state().split);
    EXPECT_THAT(at.described, HasSubstr("\"split\": " + std::to_string(at.state().split).substr(0, 5)));
}

TEST(Kiosk, EndsWhenTold) {
    TestKiosk at;
    EXPECT_TRUE(at.turn());
    EXPECT_FALSE(at.turn(QuitEvent{}));
}

TEST(Kiosk, ToursAndStops) {
    TestKiosk at(patches(kTour));
    at.tap(Part::lamp, 2);
    at.tap(Part::expert);
    at.pass(60);
    ASSERT_EQ(at.kiosk.visit().phase(), Phase::tour);
    EXPECT_EQ(at.kiosk.desk().find(Part::caption)->text, "One");
    EXPECT_EQ(at.kiosk.desk().find(Part::expert_panel), nullptr) << "the visitor's choice is forgotten";
    at.settle();
    expect_colors(at, lit(at.text, at.state()));
    at.pass(5);
    EXPECT_EQ(at.kiosk.desk().find(Part::caption)->text, "Two");
    at.settle();
    EXPECT_EQ(at.state().split, 0.25);
    expect_colors(at, lit(at.text, at.state()));
    at.pass(5);
    EXPECT_EQ(at.kiosk.desk().find(Part::caption)->text, "Three");
    at.settle();
    EXPECT_EQ(at.kiosk.show().play().exhibit().objects.size(), 2u);
    EXPECT_EQ(at.state().lamp, 1u) << "as the step before said";
    expect_colors(at, lit(replaced(at.text, "crayon-red, crayon-blue, cc-yellow", "cc-cyan, crayon-white"),
                          at.state()));
    at.pass(5);
    EXPECT_EQ(at.kiosk.desk().find(Part::caption)->text, "One") << "and again";
    at.tap(Part::lamp, 1);
    EXPECT_EQ(at.kiosk.visit().phase(), Phase::visitor);
    EXPECT_EQ(at.kiosk.desk().find(Part::caption), nullptr);
    EXPECT_EQ(at.state().lamp, 1u) << "the touch acts, too";
    EXPECT_EQ(at.state().split, 0.5);
    at.settle();
    expect_colors(at, lit(at.text, at.state()));
}

TEST(Kiosk, ATapThatEndsATourIsOfTheVisitorsScene) {
    TestKiosk at(patches(kTour));
    at.pass(60);
    at.pass(10);
    ASSERT_EQ(at.kiosk.desk().find(Part::caption)->text, "Three");
    const PxBox scene = at.kiosk.desk().layout.scene;
    const double x = scene.left + 0.1 * scene.width, y = scene.top + 0.4 * scene.height;
    at.stage.post(PointerEvent{PointerPhase::down, 0, x, y});
    at.turn(PointerEvent{PointerPhase::up, 0, x, y});
    ASSERT_TRUE(at.state().seen);
    EXPECT_EQ(at.state().seen->material, "crayon-red");
    EXPECT_NE(at.kiosk.desk().find(Part::panel), nullptr);
}

TEST(Kiosk, NightIsBlackAndATouchWakes) {
    TestKiosk at(patches("night = 20:00-08:00\n" + std::string(kTour)));
    at.minute = 20 * 60 - 1;
    at.pass(70);
    EXPECT_FALSE(dark(at));
    at.minute = 20 * 60;
    at.pass(60);
    EXPECT_EQ(at.kiosk.visit().phase(), Phase::night);
    EXPECT_TRUE(dark(at));
    EXPECT_THAT(at.described, HasSubstr("\"widgets\": []"));
    const long frames = at.stage.frames_shown();
    at.pass(3600);
    EXPECT_EQ(at.stage.frames_shown(), frames) << "nothing moves in the night";
    // Two taps at once, where nobody sees anything: the first wakes.
    for (int i = 0; i < 2; ++i)
        for (const PointerPhase phase : {PointerPhase::down, PointerPhase::up})
            at.stage.post(PointerEvent{phase, 0, 200, 100});
    at.turn();
    EXPECT_EQ(at.kiosk.visit().phase(), Phase::visitor);
    at.settle();
    EXPECT_FALSE(dark(at));
    at.pass(61);
    EXPECT_TRUE(dark(at)) << "nobody is there";
    at.minute = 8 * 60;
    at.pass(60);
    EXPECT_EQ(at.kiosk.visit().phase(), Phase::tour);
    at.settle();
    EXPECT_FALSE(dark(at));
}

TEST(Kiosk, TheNightsPictureDoesNotWander) {
    TestKiosk at(patches("night = 20:00-08:00\npixel_shift = 4\n"));
    at.minute = 22 * 60;
    at.pass(61);
    ASSERT_TRUE(dark(at));
    const long frames = at.stage.frames_shown();
    at.pass(3600);
    EXPECT_EQ(at.stage.frames_shown(), frames);
}

TEST(Kiosk, FollowsTheScreensSize) {
    TestKiosk at;
    for (const PxSize size : {PxSize{800, 480}, {480, 800}, {1280, 720}, {640, 480}}) {
        at.stage.resize(size.width_px, size.height_px);
        at.settle();
        EXPECT_EQ(at.picture(), size);
        for (const Widget& widget : at.kiosk.desk().widgets)
            EXPECT_TRUE(widget.box.right() <= size.width_px && widget.box.bottom() <= size.height_px);
        expect_colors(at, lit(at.text, at.state()));
    }
}

TEST(Kiosk, WaitsForADisplay) {
    TestKiosk at;
    at.settle();
    at.turn(DisplayGoneEvent{});
    const long frames = at.stage.frames_shown();
    at.tap(Part::lamp, 0);
    at.pass(100);
    EXPECT_EQ(at.stage.frames_shown(), frames) << "nothing is shown to nobody";
    at.turn(DisplayBackEvent{});
    EXPECT_EQ(at.stage.frames_shown(), frames + 1);
    EXPECT_THAT(at.lines, ElementsAre(HasSubstr("shown"), "event=display_gone", "event=display_back"));
}

TEST(Kiosk, BuildsEverythingAnewAfterALostContext) {
    TestKiosk at;
    at.tap(Part::lamp, 1);
    at.settle();
    const std::vector<std::uint8_t> before = at.stage.read_rgba();
    for (int i = 0; i < 100; ++i) {
        at.stage.lose_context();
        at.turn();
        ASSERT_EQ(at.kiosk.rebuilds(), i + 1);
        ASSERT_FALSE(at.stage.context_lost());
    }
    EXPECT_EQ(at.stage.read_rgba(), before);
    EXPECT_EQ(at.state().lamp, 1u) << "the visitor notices nothing else";
}

TEST(Kiosk, AContextThatGoesWhileATurnDraws) {
    TestKiosk at;
    const PxBox tile = at.kiosk.desk().find(Part::lamp, 1)->box;
    at.in_the_turn = [&] {
        if (at.state().lamp == 1u && at.kiosk.rebuilds() == 0)
            at.stage.lose_context();
    };
    at.tap(tile.left + 5, tile.top + 5);
    EXPECT_TRUE(at.stage.context_lost());
    at.settle();
    EXPECT_EQ(at.kiosk.rebuilds(), 1);
    EXPECT_EQ(at.state().lamp, 1u);
    expect_colors(at, lit(at.text, at.state()));
}

TEST(Kiosk, AFailureOfAnotherKindIsNotTakenForALoss) {
    TestKiosk at;
    at.in_the_turn = [] { throw failure("tell", "the time", "no clock"); };
    EXPECT_THROW(at.turn(), Error);
}

TEST(Kiosk, TheFocusGoesWithTheVisitor) {
    TestKiosk at(patches(kTour));
    at.turn(KeyEvent{Key::tab});
    at.turn(KeyEvent{Key::tab});
    at.turn(KeyEvent{Key::tab});
    ASSERT_TRUE(std::any_of(at.kiosk.desk().widgets.begin(), at.kiosk.desk().widgets.end(),
                            [](const Widget& widget) { return widget.focused; }));
    at.pass(61);
    ASSERT_EQ(at.kiosk.visit().phase(), Phase::tour);
    for (const Widget& widget : at.kiosk.desk().widgets)
        EXPECT_FALSE(widget.focused);
}

TEST(Kiosk, AWindowOfAnySize) {
    TestKiosk at(patches("pixel_shift = 16\n"));
    for (const PxSize size : {PxSize{6, 6}, {40, 6}, {6, 400}, {100, 100}}) {
        at.stage.resize(size.width_px, size.height_px);
        EXPECT_TRUE(at.turn()) << size.width_px << "x" << size.height_px;
    }
}

// A texture has 2048 texels a side at most.
TEST(Kiosk, AScreenLargerThanATexture) {
    TestKiosk at(patches("[tour.1]\nlamp = E\nseconds = 5\ncaption = " + std::string(60, 'm') + "\n"),
                 {3840, 2160, 0, 3840 / 941.0});
    const PxBox scene = at.kiosk.desk().layout.scene;
    at.tap(scene.left + 0.1 * scene.width, scene.top + 0.4 * scene.height);
    ASSERT_NE(at.kiosk.desk().find(Part::panel), nullptr);
    EXPECT_GT(at.kiosk.desk().find(Part::panel)->box.width, kMostTexturePx) << "else this tests nothing";
    at.pass(61);
    EXPECT_NE(at.kiosk.desk().find(Part::caption), nullptr);
    at.settle();
    expect_colors(at, lit(at.text, at.state()));
}

TEST(Kiosk, NoLineThroughASceneThatIsNotSplit) {
    TestKiosk at(replaced(patches("[tour.1]\nsplit = 0.4\nseconds = 5\n"),
                          "[compare]\nsplit = 0.5\nleft.method = tristimulus\nright.method = folded\n", ""));
    at.pass(60);
    at.settle();
    ASSERT_EQ(at.state().split, 0.4);
    const PxBox scene = at.kiosk.desk().layout.scene;
    const Seen8 seen(at);
    const int x = scene.left + static_cast<int>(std::lround(0.4 * scene.width)),
              y = scene.top + scene.height / 2;
    EXPECT_LE(apart(seen(x, y), seen(x - 8, y)), 1);
}

TEST(Kiosk, EndsWhereNobodyWaitsForTheDisplayAnyMore) {
    TestKiosk at;
    at.stage.lose_display();
    at.stage.lose_context();
    EXPECT_FALSE(at.turn());
}

/// A stage whose window cannot be opened a second time.
class OneWindow : public SurfacelessStage {
public:
    using SurfacelessStage::SurfacelessStage;
    bool rebuild() override { throw no_gl("open", "a window", "there is none"); }
};

TEST(Kiosk, EndsWhereNoWindowCanBeMadeAgain) {
    TestKiosk other;
    OneWindow stage(640, 480);
    KioskParts parts = other.parts();
    parts.stage = &stage;
    Kiosk kiosk(parts);
    stage.lose_context();
    try {
        kiosk.turn(0);
        FAIL() << "it would try for ever";
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), Exit::no_gl);
    }
}

TEST(Kiosk, TheLastWordAboutTheScreenIsTrue) {
    TestKiosk at;
    at.turn(DisplayGoneEvent{});
    at.stage.lose_context();
    at.turn();
    at.log.end();
    EXPECT_THAT(at.lines.back(), HasSubstr("event=shown")) << "a window could be opened";
}

TEST(Kiosk, ADisplayThatComesBackWithAContext) {
    TestKiosk at;
    at.turn(DisplayGoneEvent{});
    const long frames = at.stage.frames_shown();
    at.stage.lose_context();
    at.turn();
    EXPECT_EQ(at.stage.frames_shown(), frames + 1) << "a window could be opened";
}

// All at once: what follows in one turn meets whatever is there.
TEST(Kiosk, TouchesAfterALossOrAReloadInOneTurn) {
    TestKiosk at;
    const PxBox scene = at.kiosk.desk().layout.scene;
    const auto tap = [&] {
        for (const PointerPhase phase : {PointerPhase::down, PointerPhase::up})
            at.stage.post(PointerEvent{phase, 0, scene.left + 30.0, scene.top + 0.4 * scene.height});
    };
    for (int losses = 1; losses <= 2; ++losses) {
        if (losses == 1)
            at.stage.lose_context();
        tap();
        if (losses == 2) // events come in the order in which they are heard of
            at.stage.lose_context();
        at.turn();
        EXPECT_EQ(at.state().seen, (Seen{0, "crayon-red"}));
        EXPECT_EQ(at.kiosk.rebuilds(), losses);
        at.tap(Part::close);
    }
    at.stage.post(ReloadEvent{});
    tap();
    at.turn();
    EXPECT_EQ(at.state().seen, (Seen{0, "crayon-red"}));
}

TEST(Kiosk, KeysReachThePanelThroughTheWholeOfIt) {
    TestKiosk at;
    for (int i = 0; i < 40 && !(at.kiosk.desk().find(Part::expert)->focused); ++i)
        at.turn(KeyEvent{Key::tab});
    ASSERT_TRUE(at.kiosk.desk().find(Part::expert)->focused);
    at.turn(KeyEvent{Key::enter});
    EXPECT_TRUE(at.state().expert);
    at.turn(KeyEvent{Key::escape});
    EXPECT_FALSE(at.state().expert);
}

} // namespace
} // namespace metamer
