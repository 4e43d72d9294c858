// Every action by keys.
#include <gtest/gtest.h>
#include <set>

#include "kiosk/desks.h"

namespace metamer {
namespace {

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
                    scene = scene || focus == kSceneFocus;
                    if (!(focus == kSceneFocus))
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
    at.focus(kSceneFocus);
    EXPECT_TRUE(at.desk.find(Part::hint)->focused);
    at.key(Key::right);
    ASSERT_NE(at.desk.find(Part::panel), nullptr);
    EXPECT_TRUE(at.desk.find(Part::panel)->focused) << "there is no hint beside it";
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
    ASSERT_TRUE(at.focus(kSceneFocus));
    for (const std::size_t object : {0u, 1u, 2u, 0u}) {
        EXPECT_TRUE(at.key(Key::right));
        EXPECT_EQ(at.visit.state().seen->object, object);
        EXPECT_EQ(at.hands.focus(), kSceneFocus);
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
    at.visit.act(ChooseLanguage{"ar"});
    at.lay();
    at.key(Key::left);
    EXPECT_EQ(at.hands.focus(), (Focus{Part::lamp, 1})) << "the shelf runs from right to left";
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
    EXPECT_EQ(at.hands.focus(), kSceneFocus);
}

} // namespace
} // namespace metamer
