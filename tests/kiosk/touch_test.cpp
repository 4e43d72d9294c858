// Every action by touch.
#include <gtest/gtest.h>

#include "kiosk/desks.h"

namespace metamer {
namespace {

TEST(Touch, ChoosesEachLamp) {
    TestDesk at;
    for (int i = 0; i < 3; ++i) {
        ASSERT_TRUE(at.tap(Part::lamp, i));
        EXPECT_EQ(at.visit.state().lamp, static_cast<std::size_t>(i));
        for (int j = 0; j < 3; ++j)
            EXPECT_EQ(at.desk.find(Part::lamp, j)->on, i == j);
    }
}

TEST(Touch, ChoosesALampForEachSideOfTheBooth) {
    TestDesk at;
    EXPECT_EQ(at.desk.find(Part::lamp_right), nullptr);
    ASSERT_TRUE(at.tap(Part::mode));
    ASSERT_EQ(at.visit.state().mode, Mode::booth);
    ASSERT_TRUE(at.tap(Part::lamp, 0));
    ASSERT_TRUE(at.tap(Part::lamp_right, 1));
    EXPECT_EQ(at.visit.state().booth_left, 0u);
    EXPECT_EQ(at.visit.state().booth_right, 1u);
    EXPECT_EQ(at.desk.find(Part::split), nullptr) << "the booth's halves stand still";
    ASSERT_TRUE(at.tap(Part::mode));
    EXPECT_EQ(at.visit.state().mode, Mode::methods);
}

TEST(Touch, ButtonsActWhenTheFingerLifts) {
    TestDesk at;
    const PxBox box = at.desk.find(Part::expert)->box;
    EXPECT_FALSE(at.pointer(PointerPhase::down, middle_x(box), middle_y(box)));
    EXPECT_FALSE(at.visit.state().expert);
    EXPECT_TRUE(at.pointer(PointerPhase::up, box.left + 1, box.top + 1)) << "anywhere on it";
    EXPECT_TRUE(at.visit.state().expert);
    ASSERT_NE(at.desk.find(Part::expert_panel), nullptr);
    EXPECT_TRUE(at.tap(Part::expert));
    EXPECT_FALSE(at.visit.state().expert);
}

TEST(Touch, AButtonLeftOrCancelledDoesNothing) {
    TestDesk at;
    const PxBox box = at.desk.find(Part::lamp, 0)->box, other = at.desk.find(Part::lamp, 1)->box;
    at.pointer(PointerPhase::down, middle_x(box), middle_y(box));
    EXPECT_FALSE(at.pointer(PointerPhase::up, middle_x(other), middle_y(other)));
    at.pointer(PointerPhase::down, middle_x(box), middle_y(box));
    EXPECT_FALSE(at.pointer(PointerPhase::cancel, middle_x(box), middle_y(box)));
    EXPECT_FALSE(at.pointer(PointerPhase::up, middle_x(box), middle_y(box))) << "it is gone already";
    EXPECT_EQ(at.visit.state(), start_state(at.exhibit));
}

TEST(Touch, OpensEachObjectAndCloses) {
    TestDesk at;
    const PxBox scene = at.desk.layout.scene;
    const char* const names[] = {"crayon-red", "crayon-blue", "cc-yellow"};
    for (std::size_t i = 0; i < 3; ++i) {
        const double x = scene.left + (static_cast<double>(i) + 0.7) / 3 * scene.width;
        const double y = scene.top + 0.25 * scene.height;
        ASSERT_TRUE(at.tap(x, y));
        EXPECT_EQ(at.visit.state().seen, (Seen{i, names[i]}));
        const Widget* panel = at.desk.find(Part::panel);
        ASSERT_NE(panel, nullptr);
        EXPECT_NE(panel->product->title.find(at.words.name_of("en", "material", names[i])), std::string::npos)
            << panel->product->title;
        ASSERT_TRUE(at.tap(Part::close));
        EXPECT_FALSE(at.visit.state().seen);
        EXPECT_EQ(at.desk.find(Part::panel), nullptr);
    }
}

// From where a hand reaches, in the lower half: one object after the other, round and round.
TEST(Touch, GoesFromObjectToObjectOnThePanel) {
    TestDesk at;
    at.visit.act(OpenObject{1, "crayon-blue"});
    at.lay();
    for (const std::size_t object : {2u, 0u, 1u}) {
        ASSERT_TRUE(at.tap(Part::next));
        EXPECT_EQ(at.visit.state().seen->object, object);
    }
    TestDesk one(
        replaced(patches(), "materials = crayon-red, crayon-blue, cc-yellow", "materials = cc-yellow"));
    one.visit.act(OpenObject{0, "cc-yellow"});
    one.lay();
    ASSERT_NE(one.desk.find(Part::panel), nullptr);
    EXPECT_EQ(one.desk.find(Part::next), nullptr) << "there is no other";
}

TEST(Touch, ATapOnNothingClosesThePanel) {
    TestDesk at;
    const PxBox scene = at.desk.layout.scene;
    const double nothing = scene.bottom() - 2;
    EXPECT_FALSE(at.tap(scene.left + 5, nothing)) << "nothing is open";
    at.tap(scene.left + 40, scene.top + 0.3 * scene.height);
    ASSERT_TRUE(at.visit.state().seen);
    EXPECT_TRUE(at.tap(scene.left + 5, nothing));
    EXPECT_FALSE(at.visit.state().seen);
}

TEST(Touch, APanelHidesTheSceneFromFingers) {
    TestDesk at;
    const PxBox scene = at.desk.layout.scene;
    at.tap(scene.left + 40, scene.top + 0.3 * scene.height);
    const VisitState before = at.visit.state();
    const PxBox panel = at.desk.find(Part::panel)->box;
    EXPECT_FALSE(at.tap(panel.left + 3, panel.top + 3));
    EXPECT_FALSE(at.tap(middle_x(panel), panel.top + 3));
    EXPECT_EQ(at.visit.state(), before);
}

TEST(Touch, ASlippedTapOpensNothing) {
    TestDesk at;
    const PxBox scene = at.desk.layout.scene;
    const double x = scene.left + 0.2 * scene.width, y = scene.top + 0.3 * scene.height;
    const double unit = at.desk.layout.unit_px;
    at.pointer(PointerPhase::down, x, y);
    EXPECT_FALSE(at.pointer(PointerPhase::up, x + (kTapSlip + 1) * unit, y));
    at.pointer(PointerPhase::down, x, y);
    at.pointer(PointerPhase::move, x, y + 3 * kTapSlip * unit);
    EXPECT_FALSE(at.pointer(PointerPhase::up, x, y)) << "back again: it was no tap";
    at.pointer(PointerPhase::down, x, y);
    EXPECT_TRUE(at.pointer(PointerPhase::up, x + (kTapSlip - 1) * unit, y)) << "a finger is not still";
}

TEST(Touch, DragsTheSplitByItsHandle) {
    TestDesk at;
    const PxBox scene = at.desk.layout.scene;
    const Widget* handle = at.desk.find(Part::split);
    ASSERT_NE(handle, nullptr);
    const double x = handle->box.left + 3, y = middle_y(handle->box);
    EXPECT_FALSE(at.pointer(PointerPhase::down, x, y)) << "it does not jump under the finger";
    EXPECT_EQ(at.visit.state().split, 0.5);
    EXPECT_TRUE(at.pointer(PointerPhase::move, x + 0.25 * scene.width, y));
    EXPECT_NEAR(at.visit.state().split, 0.75, 1e-9);
    EXPECT_NEAR(middle_x(at.desk.find(Part::split)->box), scene.left + 0.75 * scene.width, 1);
    at.pointer(PointerPhase::move, x - 2.0 * scene.width, y);
    EXPECT_EQ(at.visit.state().split, 0) << "to the edge and no further";
    EXPECT_EQ(at.desk.find(Part::left_label), nullptr) << "there is no left half";
    at.pointer(PointerPhase::move, x + 2.0 * scene.width, y);
    EXPECT_EQ(at.visit.state().split, 1);
    EXPECT_EQ(at.desk.find(Part::right_label), nullptr);
    EXPECT_FALSE(at.pointer(PointerPhase::up, x, y)) << "no tap";
    EXPECT_FALSE(at.visit.state().seen);
}

TEST(Touch, DragsTheSplitByItsLine) {
    TestDesk at;
    const PxBox scene = at.desk.layout.scene;
    const double middle = scene.left + 0.5 * scene.width, y = scene.top + 0.3 * scene.height,
                 unit = at.desk.layout.unit_px;
    at.pointer(PointerPhase::down, middle + (kSplitReach - 0.5) * unit, y);
    EXPECT_TRUE(at.pointer(PointerPhase::move, middle + (kSplitReach - 0.5) * unit - 0.125 * scene.width, y));
    EXPECT_NEAR(at.visit.state().split, 0.375, 1e-9);
    EXPECT_FALSE(at.pointer(PointerPhase::up, middle, y)) << "a drag opens no panel";
    at.visit.act(SetSplit{0.5});
    at.lay();
    at.pointer(PointerPhase::down, middle + (kSplitReach + 0.5) * unit, y);
    EXPECT_FALSE(at.pointer(PointerPhase::move, middle + 0.3 * scene.width, y)) << "beside it";
    EXPECT_EQ(at.visit.state().split, 0.5);
}

TEST(Touch, AShortDragOfTheLineIsNoTapAndATapThereIsOne) {
    TestDesk at;
    const PxBox scene = at.desk.layout.scene;
    const double middle = scene.left + 0.5 * scene.width, y = scene.top + 0.3 * scene.height,
                 unit = at.desk.layout.unit_px;
    at.pointer(PointerPhase::down, middle, y);
    at.pointer(PointerPhase::move, middle + 3 * unit, y);
    EXPECT_FALSE(at.pointer(PointerPhase::up, middle + 3 * unit, y));
    EXPECT_FALSE(at.visit.state().seen);
    at.tap(middle + 3 * unit, y);
    EXPECT_TRUE(at.visit.state().seen) << "what lies under the line can be tapped";
}

TEST(Touch, TheSliderFollowsAtOnce) {
    TestDesk at;
    const PxBox box = at.desk.find(Part::strength)->box;
    const PxBox track = slider_track(box, at.desk.layout.unit_px);
    const auto at_share = [&](double share) { return track.left + share * track.width; };
    EXPECT_TRUE(at.pointer(PointerPhase::down, at_share(0.75), middle_y(box)));
    EXPECT_NEAR(at.visit.state().strength, strength_of_slider(0.75), 1e-9);
    EXPECT_TRUE(at.pointer(PointerPhase::move, at_share(0.25), 0)) << "wherever the finger wanders";
    EXPECT_NEAR(at.visit.state().strength, strength_of_slider(0.25), 1e-9);
    EXPECT_NEAR(at.desk.find(Part::strength)->value, 0.25, 1e-9);
    at.pointer(PointerPhase::move, -500, 0);
    EXPECT_NEAR(at.visit.state().strength, kLeastStrength, 1e-9);
    at.pointer(PointerPhase::move, 5000, 0);
    EXPECT_NEAR(at.visit.state().strength, kMostStrength, 1e-9);
    EXPECT_FALSE(at.pointer(PointerPhase::up, 5000, 0));
    EXPECT_FALSE(at.pointer(PointerPhase::move, 0, 0)) << "let go";
}

TEST(Touch, RightToLeftTheSliderRunsBackwards) {
    TestDesk at;
    at.visit.act(ChooseLanguage{"ar"});
    at.lay();
    const PxBox box = at.desk.find(Part::strength)->box;
    const PxBox track = slider_track(box, at.desk.layout.unit_px);
    at.pointer(PointerPhase::down, track.left + 0.25 * track.width, middle_y(box));
    EXPECT_NEAR(at.visit.state().strength, strength_of_slider(0.75), 1e-9);
}

TEST(Touch, RightToLeftMirrorsControlsButNotTheHalves) {
    TestDesk at;
    const PxBox mode = at.desk.find(Part::mode)->box, left = at.desk.find(Part::left_label)->box;
    at.visit.act(ChooseLanguage{"ar"});
    at.lay();
    EXPECT_EQ(at.desk.find(Part::mode)->box.left, at.screen.width_px - mode.right());
    EXPECT_EQ(at.desk.find(Part::left_label)->box, left);
    for (const Widget& widget : at.desk.widgets)
        EXPECT_TRUE(widget.right_to_left);
    // Its lamps are still each its own.
    ASSERT_TRUE(at.tap(Part::lamp, 1));
    EXPECT_EQ(at.visit.state().lamp, 1u);
    ASSERT_TRUE(at.tap(Part::mode));
    EXPECT_LT(at.desk.find(Part::lamp, 2)->box.right(), at.screen.width_px / 2 + 1) << "left stays left";
    ASSERT_TRUE(at.tap(Part::lamp_right, 2));
    EXPECT_EQ(at.visit.state().booth_right, 2u);
}

TEST(Touch, ASecondFingerHasAHandOfItsOwn) {
    TestDesk at;
    const PxBox handle = at.desk.find(Part::split)->box, lamp = at.desk.find(Part::lamp, 1)->box;
    const double width = at.desk.layout.scene.width;
    at.pointer(PointerPhase::down, middle_x(handle), middle_y(handle), 7);
    at.pointer(PointerPhase::down, middle_x(lamp), middle_y(lamp), 9);
    at.pointer(PointerPhase::move, middle_x(handle) - 0.25 * width, 0, 7);
    EXPECT_NEAR(at.visit.state().split, 0.25, 1e-9);
    EXPECT_TRUE(at.pointer(PointerPhase::up, middle_x(lamp), middle_y(lamp), 9));
    EXPECT_EQ(at.visit.state().lamp, 1u);
    at.pointer(PointerPhase::move, middle_x(handle), 0, 7);
    EXPECT_NEAR(at.visit.state().split, 0.5, 1e-9) << "the first still holds the split";
    EXPECT_FALSE(at.pointer(PointerPhase::up, middle_x(lamp), middle_y(lamp), 3)) << "never came down";
}

TEST(Touch, ChoosesEachLanguage) {
    TestDesk at;
    const auto& languages = at.words.languages();
    ASSERT_GE(languages.size(), 6u);
    for (std::size_t i = languages.size(); i-- > 0;) {
        ASSERT_TRUE(at.tap(Part::language, static_cast<int>(i)));
        EXPECT_EQ(at.visit.state().language, languages[i].code);
        EXPECT_TRUE(at.desk.find(Part::language, static_cast<int>(i))->on);
        EXPECT_EQ(at.desk.find(Part::language, static_cast<int>(i))->text, languages[i].name);
    }
}

TEST(Touch, LetGoForgetsFingersAndFocus) {
    TestDesk at;
    const PxBox lamp = at.desk.find(Part::lamp, 0)->box;
    at.key(Key::tab);
    at.pointer(PointerPhase::down, middle_x(lamp), middle_y(lamp));
    EXPECT_FALSE(at.hands.focus()) << "a touch takes the keyboard's focus away";
    at.key(Key::tab);
    at.hands.let_go();
    EXPECT_FALSE(at.hands.focus());
    EXPECT_FALSE(at.pointer(PointerPhase::up, middle_x(lamp), middle_y(lamp)));
}

} // namespace
} // namespace metamer
