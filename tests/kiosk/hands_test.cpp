// Every action by touch and by keys.
#include <gtest/gtest.h>
#include <set>

#include "kiosk/desks.h"

namespace metamer {
namespace {

constexpr Focus kScene{Part::hint, 0};

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

std::set<std::pair<Part, int>> touchable(const Desk& desk) {
    std::set<std::pair<Part, int>> all;
    for (const Widget& widget : desk.widgets)
        if (widget.touchable && widget.part != Part::panel)
            all.insert({widget.part, widget.index});
    return all;
}

// Once around by this key, from nowhere to where it began.
std::vector<Focus> round_by(TestDesk& at, Key key) {
    std::vector<Focus> seen;
    for (int i = 0; i < 100; ++i) {
        at.key(key);
        if (!seen.empty() && at.hands.focus() == seen.front())
            break;
        seen.push_back(*at.hands.focus());
    }
    return seen;
}

TEST(Keys, TheFocusReachesEverything) {
    for (const bool booth : {false, true})
        for (const bool panel : {false, true}) {
            TestDesk at;
            if (booth)
                at.visit.act(ChooseMode{Mode::booth});
            at.lay();
            if (panel)
                at.visit.act(OpenObject{0, at.drawn().objects[0].material.material.name});
            at.lay();
            const auto expected = touchable(at.desk);
            ASSERT_GE(expected.size(), 11u);
            for (const Key key : {Key::tab, Key::down, Key::back_tab, Key::up}) {
                std::set<std::pair<Part, int>> reached;
                bool scene = false;
                for (const Focus& focus : round_by(at, key)) {
                    scene = scene || focus == kScene;
                    if (!(focus == kScene))
                        reached.insert({focus.part, focus.index});
                }
                EXPECT_TRUE(scene);
                EXPECT_EQ(reached, expected) << booth << panel;
                at.hands.let_go();
            }
        }
}

TEST(Keys, TheFocusIsSeen) {
    TestDesk at;
    ASSERT_TRUE(at.focus({Part::lamp, 2}));
    for (const Widget& widget : at.desk.widgets)
        EXPECT_EQ(widget.focused, widget.part == Part::lamp && widget.index == 2);
    at.focus(kScene);
    EXPECT_TRUE(at.desk.find(Part::hint)->focused);
}

TEST(Keys, EnterDoesWhatATapDoes) {
    for (const auto& [part, index] : touchable(TestDesk().desk)) {
        if (part == Part::strength || part == Part::split)
            continue;
        TestDesk tapped, keyed;
        tapped.tap(part, index);
        ASSERT_TRUE(keyed.focus({part, index}));
        EXPECT_TRUE(keyed.key(Key::enter));
        EXPECT_EQ(keyed.visit.state(), tapped.visit.state()) << static_cast<int>(part) << ' ' << index;
    }
}

TEST(Keys, EnterChoosesForEachSideOfTheBooth) {
    TestDesk at;
    at.visit.act(ChooseMode{Mode::booth});
    at.lay();
    ASSERT_TRUE(at.focus({Part::lamp, 0}));
    at.key(Key::enter);
    ASSERT_TRUE(at.focus({Part::lamp_right, 1}));
    at.key(Key::enter);
    EXPECT_EQ(at.visit.state().booth_left, 0u);
    EXPECT_EQ(at.visit.state().booth_right, 1u);
}

TEST(Keys, ArrowsMoveTheSliderAndTheSplit) {
    TestDesk at;
    ASSERT_TRUE(at.focus({Part::strength, 0}));
    EXPECT_TRUE(at.key(Key::right));
    const double more = at.visit.state().strength;
    EXPECT_GT(more, 1);
    at.key(Key::left);
    EXPECT_NEAR(at.visit.state().strength, 1, 1e-9);
    for (int i = 0; i < 50; ++i)
        at.key(Key::left);
    EXPECT_NEAR(at.visit.state().strength, kLeastStrength, 1e-9);
    ASSERT_TRUE(at.focus({Part::split, 0}));
    at.key(Key::left);
    EXPECT_LT(at.visit.state().split, 0.5);
    for (int i = 0; i < 50; ++i)
        at.key(Key::right);
    EXPECT_EQ(at.visit.state().split, 1);
    at.key(Key::left);
    EXPECT_LT(at.visit.state().split, 1) << "and back from the edge";
}

TEST(Keys, RightToLeftTheSliderMovesAsItIsSeen) {
    TestDesk at;
    at.visit.act(ChooseLanguage{"ar"});
    at.lay();
    ASSERT_TRUE(at.focus({Part::strength, 0}));
    at.key(Key::left);
    EXPECT_GT(at.visit.state().strength, 1) << "more lies on the left";
    ASSERT_TRUE(at.focus({Part::split, 0}));
    at.key(Key::left);
    EXPECT_LT(at.visit.state().split, 0.5) << "the split has no language";
}

TEST(Keys, ArrowsGoFromObjectToObject) {
    TestDesk at;
    ASSERT_TRUE(at.focus(kScene));
    for (const std::size_t object : {0u, 1u, 2u, 0u}) {
        EXPECT_TRUE(at.key(Key::right));
        EXPECT_EQ(at.visit.state().seen->object, object);
        EXPECT_EQ(at.hands.focus(), kScene);
    }
    at.key(Key::left);
    EXPECT_EQ(at.visit.state().seen->object, 2u);
    at.key(Key::enter);
    EXPECT_EQ(at.visit.state().seen->object, 2u) << "it is open already";
}

TEST(Keys, ElsewhereArrowsMoveTheFocus) {
    TestDesk at;
    ASSERT_TRUE(at.focus({Part::lamp, 0}));
    EXPECT_FALSE(at.key(Key::right));
    EXPECT_EQ(at.hands.focus(), (Focus{Part::lamp, 1}));
    EXPECT_FALSE(at.key(Key::left));
    EXPECT_EQ(at.hands.focus(), (Focus{Part::lamp, 0}));
}

TEST(Keys, EnterWithoutFocusOpensTheFirstObject) {
    TestDesk at;
    EXPECT_TRUE(at.key(Key::enter));
    EXPECT_EQ(at.visit.state().seen, (Seen{0, "crayon-red"}));
}

TEST(Keys, EscapeClosesOneAfterTheOther) {
    TestDesk at;
    at.visit.act(ToggleExpert{});
    at.key(Key::enter);
    ASSERT_TRUE(at.visit.state().seen);
    ASSERT_TRUE(at.focus({Part::close, 0}));
    EXPECT_TRUE(at.key(Key::escape));
    EXPECT_FALSE(at.visit.state().seen);
    EXPECT_TRUE(at.key(Key::escape));
    EXPECT_FALSE(at.visit.state().expert);
    EXPECT_FALSE(at.key(Key::escape));
    EXPECT_FALSE(at.hands.focus());
}

TEST(Keys, AFocusThatIsGoneGoesOn) {
    TestDesk at;
    at.key(Key::enter);
    ASSERT_TRUE(at.focus({Part::close, 0}));
    EXPECT_TRUE(at.key(Key::enter)) << "closes";
    EXPECT_EQ(at.desk.find(Part::close), nullptr);
    EXPECT_FALSE(at.key(Key::enter)) << "nothing is there any more";
    at.key(Key::tab);
    EXPECT_EQ(at.hands.focus(), kScene);
}

} // namespace
} // namespace metamer
