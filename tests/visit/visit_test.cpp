#include "visit/visit.h"

#include <gtest/gtest.h>
#include <limits>

#include "visit/visits.h"

namespace metamer {
namespace {

constexpr int kNoon = 12 * 60, kMidnight = 0;
constexpr const char* kTour =
    "[tour.1]\nlamp = D65\nsplit = 0.5\nseconds = 4\ncaption = Day\ncaption.de = Tag\n"
    "[tour.2]\nlamp = F11\nseconds = 6\n"
    "[tour.3]\nmaterials = crayon-green\nseconds = 5\n";

TEST(Visit, WishesChangeTheState) {
    const Exhibit exhibit = visited();
    Visit visit(exhibit, 100);
    visit.touch(101);
    visit.act(ChooseLamp{2});
    visit.act(SetStrength{3});
    visit.act(SetSplit{0.75});
    visit.act(OpenObject{1, "crayon-blue"});
    visit.act(ChooseLanguage{"de"});
    visit.act(ToggleExpert{});
    EXPECT_EQ(visit.state().lamp, 2u);
    EXPECT_EQ(visit.state().strength, 3);
    EXPECT_EQ(visit.state().split, 0.75);
    EXPECT_EQ(visit.state().seen, (Seen{1, "crayon-blue"}));
    EXPECT_EQ(visit.state().language, "de");
    EXPECT_TRUE(visit.state().expert);
    visit.act(ToggleExpert{});
    visit.act(ClosePanel{});
    EXPECT_FALSE(visit.state().expert);
    EXPECT_FALSE(visit.state().seen);
}

TEST(Visit, WishesStayWithinWhatThereIs) {
    const Exhibit exhibit = visited();
    Visit visit(exhibit, 0);
    visit.act(ChooseLamp{4});
    EXPECT_FALSE(visit.state().lamp);
    visit.act(SetStrength{1e9});
    EXPECT_EQ(visit.state().strength, kMostStrength);
    visit.act(SetStrength{-1});
    EXPECT_EQ(visit.state().strength, kLeastStrength);
    visit.act(SetSplit{-2});
    EXPECT_EQ(visit.state().split, 0);
}

TEST(Visit, TheBoothHasTwoLamps) {
    const Exhibit exhibit = visited();
    Visit visit(exhibit, 0);
    visit.act(OpenObject{0, "crayon-red"});
    visit.act(ChooseMode{Mode::booth});
    EXPECT_FALSE(visit.state().seen) << "another scene";
    visit.act(ChooseLamp{0});
    visit.act(ChooseLamp{2, true});
    EXPECT_EQ(visit.state().booth_left, 0u);
    EXPECT_EQ(visit.state().booth_right, 2u);
    EXPECT_FALSE(visit.state().lamp) << "the other mode keeps its own";
}

TEST(Visit, TheTourRunsWhenNobodyTouches) {
    const Exhibit exhibit = visited(kTour);
    Visit visit(exhibit, 0);
    visit.touch(1);
    visit.act(SetStrength{5});
    EXPECT_EQ(visit.next_s(), 11);
    visit.tick(10.9, kNoon);
    EXPECT_EQ(visit.phase(), Phase::visitor);
    visit.tick(11, kNoon);
    EXPECT_EQ(visit.phase(), Phase::tour);
    EXPECT_EQ(visit.step(), 0);
    EXPECT_EQ(visit.state().lamp, 1u);
    EXPECT_EQ(visit.state().split, 0.5);
    EXPECT_EQ(visit.state().strength, 1) << "the visitor's choice is forgotten";
    EXPECT_EQ(visit.caption(), "Day");
    EXPECT_EQ(visit.next_s(), 15);
    visit.tick(15, kNoon);
    EXPECT_EQ(visit.step(), 1);
    EXPECT_EQ(visit.state().lamp, 3u);
    EXPECT_EQ(visit.state().split, 0.5) << "as before";
    EXPECT_EQ(visit.caption(), "");
    EXPECT_EQ(visit.scene(), nullptr);
    visit.tick(21, kNoon);
    ASSERT_NE(visit.scene(), nullptr);
    EXPECT_EQ(visit.scene()->objects.size(), 1u);
    visit.tick(26, kNoon);
    EXPECT_EQ(visit.step(), 0) << "and again";
    EXPECT_EQ(visit.scene(), nullptr);
}

TEST(Visit, ATouchStopsTheTourAndActs) {
    const Exhibit exhibit = visited(kTour);
    Visit visit(exhibit, 0);
    visit.tick(10, kNoon);
    ASSERT_EQ(visit.phase(), Phase::tour);
    visit.act(SetSplit{0.9});
    EXPECT_EQ(visit.state().split, 0.5) << "nobody is there to wish";
    EXPECT_FALSE(visit.touch(12)) << "it may act as well";
    EXPECT_EQ(visit.phase(), Phase::visitor);
    EXPECT_EQ(visit.state(), start_state(exhibit));
    EXPECT_EQ(visit.caption(), "");
    EXPECT_EQ(visit.step(), -1);
    EXPECT_EQ(visit.next_s(), 22);
}

TEST(Visit, WithoutATourTheStartStands) {
    const Exhibit exhibit = visited();
    Visit visit(exhibit, 0);
    visit.touch(1);
    visit.act(ChooseLamp{2});
    visit.tick(11, kNoon);
    EXPECT_EQ(visit.phase(), Phase::tour);
    EXPECT_EQ(visit.state(), start_state(exhibit));
    EXPECT_EQ(visit.next_s(), std::numeric_limits<double>::infinity());
    visit.tick(1e6, kNoon);
    EXPECT_EQ(visit.step(), -1);
}

TEST(Visit, TheNightIsDarkUntilATouch) {
    const Exhibit exhibit = visited(std::string("night = 22:00-06:00\n") + kTour);
    Visit visit(exhibit, 0);
    visit.tick(5, 23 * 60);
    EXPECT_EQ(visit.phase(), Phase::visitor) << "somebody is there";
    visit.tick(10, 23 * 60);
    EXPECT_EQ(visit.phase(), Phase::night);
    EXPECT_EQ(visit.next_s(), 70) << "looks at the clock every minute";
    EXPECT_TRUE(visit.touch(20)) << "it only wakes";
    EXPECT_EQ(visit.phase(), Phase::visitor);
    visit.tick(30, kMidnight);
    EXPECT_EQ(visit.phase(), Phase::night) << "over midnight";
    visit.tick(40, 6 * 60);
    EXPECT_EQ(visit.phase(), Phase::tour);
    EXPECT_EQ(visit.step(), 0);
    visit.tick(41, 22 * 60);
    EXPECT_EQ(visit.phase(), Phase::night);
    EXPECT_EQ(visit.caption(), "");
}

TEST(Visit, TheDayMayBeTheDarkPart) {
    const Exhibit exhibit = visited("night = 08:00-17:00\n");
    Visit visit(exhibit, 0);
    visit.tick(10, 8 * 60);
    EXPECT_EQ(visit.phase(), Phase::night);
    visit.tick(11, 17 * 60);
    EXPECT_EQ(visit.phase(), Phase::tour);
}

TEST(Visit, AReloadKeepsWhatTheVisitorChose) {
    const Exhibit before = visited(), after = visited("pixel_shift = 1\n");
    Exhibit smaller = visited();
    smaller.kiosk.lamps.resize(2);
    smaller.kiosk.booth_right = 0;
    Visit visit(before, 0);
    visit.touch(1);
    visit.act(ChooseLamp{2});
    visit.act(SetSplit{0.6});
    visit.act(OpenObject{1, "crayon-blue"});
    visit.take_over(after);
    EXPECT_EQ(visit.state().lamp, 2u);
    EXPECT_EQ(visit.state().split, 0.6);
    EXPECT_FALSE(visit.state().seen) << "objects may be others";
    visit.take_over(smaller);
    EXPECT_FALSE(visit.state().lamp) << "no longer on the shelf";
    EXPECT_EQ(visit.state().booth_right, 0u);
}

TEST(Visit, AReloadTakesOverWhatNobodyChose) {
    const Exhibit before = visited();
    Exhibit after = visited();
    after.kiosk.language = "de";
    after.compare.emplace().split = 0.25;
    after.kiosk.booth_left = 2;
    Visit visit(before, 0);
    visit.touch(1);
    visit.act(SetStrength{2});
    visit.take_over(after);
    EXPECT_EQ(visit.state().language, "de");
    EXPECT_EQ(visit.state().split, 0.25);
    EXPECT_EQ(visit.state().booth_left, 2u);
    EXPECT_EQ(visit.state().strength, 2) << "somebody chose it";
    visit.act(ChooseMode{Mode::booth});
    Exhibit bare = visited();
    bare.kiosk.lamps.clear();
    visit.take_over(bare);
    EXPECT_EQ(visit.state().mode, Mode::methods) << "no lamps for a booth";
}

TEST(Visit, NoBoothWhereTheShelfIsNotShown) {
    const Exhibit before = visited();
    Exhibit own = visited();
    own.compare.emplace();
    own.compare->left.lamp = own.compare->right.lamp = own.kiosk.lamps[0];
    Visit visit(before, 0);
    visit.touch(1);
    visit.act(ChooseMode{Mode::booth});
    ASSERT_EQ(visit.state().mode, Mode::booth);
    visit.take_over(own);
    EXPECT_EQ(visit.state().mode, Mode::methods) << "nothing would lead out of it";
    visit.act(ChooseMode{Mode::booth});
    EXPECT_EQ(visit.state().mode, Mode::methods);
}

TEST(Visit, AReloadBeginsTheTourAnew) {
    const Exhibit before = visited(kTour), after = visited("[tour.1]\nseconds = 3\n");
    Visit visit(before, 0);
    visit.tick(10, kNoon);
    visit.tick(14, kNoon);
    ASSERT_EQ(visit.step(), 1);
    visit.take_over(after);
    visit.tick(15, kNoon);
    EXPECT_EQ(visit.phase(), Phase::tour);
    EXPECT_EQ(visit.step(), 0);
    EXPECT_EQ(visit.next_s(), 18);
}

} // namespace
} // namespace metamer
