// What stands on the screen at a moment.
#include "kiosk/desk.h"

#include <gmock/gmock.h>

#include "kiosk/desks.h"
#include "kiosk/reason_words.h"
#include "overlay/painter.h"

namespace metamer {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

const char* const kTour =
    "[tour.1]\nlamp = E\ncaption = All the same\ncaption.de = Alles gleich\nseconds = 5\n"
    "[tour.2]\nmaterials = cc-red, crayon-gray\nseconds = 5\n";

// Every widget says something, and nothing that a program meant to replace.
void expect_words(const TestDesk& at, const std::string& where) {
    EXPECT_FALSE(at.desk.widgets.empty()) << where;
    for (const Widget& widget : at.desk.widgets) {
        EXPECT_THAT(widget.text, Not(IsEmpty())) << where << ", part " << static_cast<int>(widget.part);
        EXPECT_THAT(widget.text, Not(HasSubstr("{"))) << where;
        if (widget.expert)
            for (const auto& row : widget.expert->rows) {
                EXPECT_THAT(row[0], Not(IsEmpty())) << where;
                EXPECT_THAT(row[1], Not(IsEmpty())) << where;
                EXPECT_THAT(row[1], Not(HasSubstr("{"))) << where;
            }
    }
}

// A missing word would end the kiosk: every state in every language.
TEST(Desk, HasWordsForEverything) {
    for (const char* halves : {"", "left.method = rgb\nright.method = spectral\n",
                               "left.method = packed\nright.method = prefiltered\n",
                               "left.lamp = D65\nright.lamp = F11\nleft.method = auto\n",
                               "left.working_space = Adobe-D65\n", "left.method = reduced\n"}) {
        const std::string scene = "[atlas]\nquantization = thesis\n[scene]\nkind = loaf\nmaterials = "
                                  "crayon-red, cc-yellow\n[lamp.1]\nspectrum = F11\n";
        const std::string compare = *halves ? std::string("[compare]\n") + halves : "";
        TestDesk at(scene + compare + "[kiosk]\nlamps = E, D65, F11\n" + kTour);
        at.notice = "n";
        for (const Language& language : at.words.languages())
            for (const Mode mode : {Mode::methods, Mode::booth})
                for (const bool open : {false, true}) {
                    at.visit.act(ChooseLanguage{language.code});
                    at.visit.act(ChooseMode{mode});
                    if (at.visit.state().expert != open)
                        at.visit.act(ToggleExpert{});
                    at.visit.act(ClosePanel{});
                    at.lay();
                    if (open)
                        at.visit.act(OpenObject{0, at.drawn().objects[0].material.material.name});
                    at.lay();
                    EXPECT_EQ(at.desk.find(Part::panel) != nullptr, open);
                    expect_words(at, language.code + " " + halves + (open ? " open" : ""));
                }
    }
}

// Where each half has a lamp of its own, a shelf would choose for nobody.
TEST(Desk, HasNoShelfForHalvesWithLampsOfTheirOwn) {
    const auto text = [](const char* lamps) {
        return replaced(patches(), "left.method = tristimulus\n",
                        std::string("left.method = auto\n") + lamps);
    };
    TestDesk one(text("left.lamp = D65\n")), both(text("left.lamp = D65\nright.lamp = F11\n"));
    one.lay();
    both.lay();
    EXPECT_NE(one.desk.find(Part::lamp, 2), nullptr);
    EXPECT_EQ(both.desk.find(Part::lamp, 0), nullptr);
    EXPECT_EQ(both.desk.find(Part::mode), nullptr) << "nor lamps to compare";
    EXPECT_NE(both.desk.find(Part::strength), nullptr);
    EXPECT_EQ(one.desk.find(Part::hint)->text, one.words.text("en", "hint.methods"));
    EXPECT_EQ(both.desk.find(Part::hint)->text, "Tap an object") << "nor is a lamp to pick";
}

TEST(Desk, HasNoSplitWhereEachHalfShowsAll) {
    TestDesk at("[atlas]\nquantization = thesis\n[scene]\nkind = booth\nmaterials = cc-orange\n"
                "[compare]\nsplit = 0\nleft.lamp = D65\nright.lamp = F11\n[kiosk]\nlamps = E, D65\n");
    at.lay();
    EXPECT_EQ(at.desk.find(Part::split), nullptr);
    EXPECT_NE(at.desk.find(Part::left_label), nullptr);
    EXPECT_NE(at.desk.find(Part::right_label), nullptr);
}

TEST(Desk, HasWordsForTheTour) {
    for (const Language& language : all_words().languages()) {
        TestDesk at(patches("language = " + language.code + "\n" + kTour));
        for (const double now : {100.0, 106.0}) {
            at.visit.tick(now, 0);
            ASSERT_EQ(at.visit.phase(), Phase::tour);
            at.lay();
            expect_words(at, language.code);
        }
    }
}

TEST(Desk, TellsWhoseTurnItIs) {
    TestDesk at(patches(kTour));
    EXPECT_EQ(at.desk.find(Part::hint)->text, at.words.text("en", "hint.methods"));
    at.tap(Part::mode);
    EXPECT_EQ(at.desk.find(Part::hint)->text, at.words.text("en", "hint.booth"));
    at.visit.tick(100, 0);
    at.lay();
    EXPECT_EQ(at.desk.find(Part::caption)->text, "All the same");
    EXPECT_EQ(at.desk.find(Part::hint), nullptr) << "the caption stands there";
    at.visit.tick(106, 0);
    at.lay();
    EXPECT_EQ(at.desk.find(Part::caption), nullptr);
    EXPECT_EQ(at.desk.find(Part::hint)->text, at.words.text("en", "hint.start"));
}

TEST(Desk, SpeaksTheLanguageOfTheCaption) {
    TestDesk at(patches("language = de\n" + std::string(kTour)));
    at.visit.tick(100, 0);
    at.lay();
    EXPECT_EQ(at.desk.find(Part::caption)->text, "Alles gleich");
    EXPECT_EQ(at.desk.find(Part::expert)->text, at.words.text("de", "button.expert"));
}

TEST(Desk, NamesTheHalves) {
    TestDesk at;
    EXPECT_EQ(at.desk.find(Part::left_label)->text, at.words.text("en", "half.numbers"));
    EXPECT_EQ(at.desk.find(Part::right_label)->text, at.words.text("en", "half.wavelengths"));
    EXPECT_FALSE(at.desk.find(Part::left_label)->touchable);
    at.tap(Part::mode);
    EXPECT_EQ(at.desk.find(Part::left_label)->text,
              at.words.text("en", "booth.match", {{"lamp", at.words.name_of("en", "lamp", "D65")}}));
    EXPECT_EQ(at.desk.find(Part::right_label)->text,
              at.words.text("en", "booth.part", {{"lamp", at.words.name_of("en", "lamp", "F11")}}));
    at.tap(Part::lamp_right, 1);
    EXPECT_EQ(at.desk.find(Part::right_label)->text,
              at.words.text("en", "booth.match", {{"lamp", at.words.name_of("en", "lamp", "D65")}}))
        << "under one lamp nothing parts";
}

// Other names and keys, one light: what decides is what the cards look like.
TEST(Desk, TwoLampsOfOneSpectrumPartNothing) {
    TestDesk at("[atlas]\nquantization = thesis\n[scene]\nkind = patches\nmaterials = cc-red\n[lamp.1]\n"
                "spectrum = E\n[kiosk]\nlamps = A2800, planck:2800, F11\nbooth.left = A2800\n"
                "booth.right = planck:2800\n");
    at.tap(Part::mode);
    const auto match = [&](const char* lamp) {
        return at.words.text("en", "booth.match", {{"lamp", at.words.name_of("en", "lamp", lamp)}});
    };
    EXPECT_EQ(at.desk.find(Part::left_label)->text, match("A2800"));
    EXPECT_EQ(at.desk.find(Part::right_label)->text, match("planck:2800"));
    at.tap(Part::lamp_right, 2);
    EXPECT_EQ(at.desk.find(Part::right_label)->text,
              at.words.text("en", "booth.part", {{"lamp", at.words.name_of("en", "lamp", "F11")}}));
}

TEST(Desk, WithoutAComparisonNothingIsSplit) {
    TestDesk at("[atlas]\nquantization = thesis\n[scene]\nkind = loaf\nmaterials = cc-red\n[lamp.1]\n"
                "spectrum = E\n[kiosk]\nlamps = E, F11\n");
    EXPECT_EQ(at.desk.find(Part::split), nullptr);
    EXPECT_EQ(at.desk.find(Part::left_label), nullptr);
    EXPECT_EQ(at.desk.find(Part::right_label)->text, at.words.text("en", "half.wavelengths"));
}

TEST(Desk, ShowsTheStrength) {
    TestDesk at;
    EXPECT_EQ(at.desk.find(Part::strength)->text,
              at.words.text("en", "slider.strength", {{"factor", "1.0"}}));
    EXPECT_EQ(at.desk.find(Part::strength)->value, 0.5);
    const auto factor = [&](double strength) {
        at.visit.act(SetStrength{strength});
        at.lay();
        return at.desk.find(Part::strength)->text;
    };
    at.visit.act(ChooseLanguage{"de"});
    const auto german = [&](const char* number) {
        return at.words.text("de", "slider.strength", {{"factor", number}});
    };
    EXPECT_EQ(factor(12.4), german("12"));
    EXPECT_EQ(factor(9.94), german("9,9"));
    EXPECT_EQ(factor(0.997), german("1,0"));
    EXPECT_EQ(factor(0.25), german("0,25")) << "as Germans write it";
    EXPECT_EQ(factor(kLeastStrength), german("0,05"));
}

TEST(Desk, LampsShowTheirSpectra) {
    TestDesk at;
    const Bars even = at.desk.find(Part::lamp, 0)->bars, tube = at.desk.find(Part::lamp, 2)->bars;
    ASSERT_EQ(even.size(), static_cast<std::size_t>(kIntervals));
    EXPECT_THAT(even, testing::Each(testing::FloatNear(1, 1e-6F)));
    EXPECT_EQ(*std::max_element(tube.begin(), tube.end()), 1.0f);
    EXPECT_LT(*std::min_element(tube.begin(), tube.end()), 0.1f);
    EXPECT_EQ(at.desk.find(Part::lamp, 2)->text, at.words.name_of("en", "lamp", "F11"));
    EXPECT_TRUE(at.desk.find(Part::lamp, 2)->on) << "the exhibit's own lamp";
}

TEST(Desk, TheTopmostIsTouched) {
    TestDesk at;
    at.key(Key::enter);
    const Widget* close = at.desk.find(Part::close);
    EXPECT_EQ(at.desk.at(middle_x(close->box), middle_y(close->box)), close) << "not the panel under it";
    EXPECT_EQ(at.desk.at(-1, -1), nullptr);
    const PxBox label = at.desk.find(Part::left_label)->box;
    EXPECT_EQ(at.desk.at(middle_x(label), middle_y(label)), nullptr) << "touches go through it";
}

TEST(Desk, TellsExpertsHow) {
    TestDesk at;
    at.tap(Part::expert);
    std::vector<std::string> values;
    for (const auto& row : at.desk.find(Part::expert_panel)->expert->rows)
        values.push_back(row[1]);
    EXPECT_THAT(
        values,
        ElementsAre(at.words.text("en", "method.tristimulus") + " | " + at.words.text("en", "method.folded"),
                    "sRGB-D65", "3 | 471", at.words.text("en", "difference.number", {{"number", "0.50"}}),
                    reason_words(at.plan().halves[1].objects[0].why, at.words, "en"),
                    at.words.text("en", "expert.milliseconds", {{"ms", "12.3"}})));
}

TEST(Desk, TellsExpertsOfTheHalvesAsTheyLieWhateverWayWordsRun) {
    TestDesk at;
    at.tap(Part::expert);
    at.visit.act(ChooseLanguage{"ar"});
    at.lay();
    EXPECT_EQ(at.desk.find(Part::expert_panel)->expert->rows[2][1],
              "\u2066\u20683\u2069 | \u2068471\u2069\u2069");
}

TEST(Desk, TellsExpertsOfTheObjectThatIsOpen) {
    TestDesk at(patches("[object.cc-yellow]\nmethod = spectral\n"));
    at.visit.act(ToggleExpert{});
    at.visit.act(OpenObject{2, "cc-yellow"});
    at.lay();
    EXPECT_EQ(at.desk.find(Part::expert_panel)->expert->rows[0][1], at.words.text("en", "method.spectral"));
    EXPECT_EQ(at.desk.find(Part::expert_panel)->expert->rows[2][1], "64");
}

TEST(Desk, NothingLeavesAnyScreen) {
    for (const ScreenSize screen : {ScreenSize{640, 480, 0},
                                    {800, 480, 0},
                                    {1280, 720, 0},
                                    {1920, 1080, 0},
                                    {480, 800, 0},
                                    {1080, 1920, 0}})
        for (const char* language : {"en", "ar"}) {
            TestDesk at(patches(), screen);
            at.notice = "n";
            at.visit.act(ChooseLanguage{language});
            at.visit.act(ToggleExpert{});
            at.visit.act(OpenObject{0, "crayon-red"});
            at.lay();
            for (const Widget& widget : at.desk.widgets) {
                const PxBox& box = widget.box;
                EXPECT_TRUE(box.left >= 0 && box.top >= 0 && box.right() <= screen.width_px &&
                            box.bottom() <= screen.height_px)
                    << screen.width_px << 'x' << screen.height_px << ' ' << widget.text;
            }
        }
}

// Two methods, and a reason that tells of a third.
TEST(Desk, ExpertsReadAllOfItInEveryLanguage) {
    for (const ScreenSize screen : {ScreenSize{640, 480, 0},
                                    {480, 640, 0},
                                    {800, 480, 5.2},
                                    {1280, 720, 0},
                                    {1920, 1080, 0},
                                    {720, 1280, 0}}) {
        TestDesk at("[atlas]\nquantization = thesis\n[scene]\nkind = media\n[lamp.1]\nspectrum = F11\n"
                    "[compare]\nleft.method = packed\n[kiosk]\nlamps = E, D65, F11\n",
                    screen);
        const std::vector<ObjectPlan>& plans = at.plan().halves.back().objects;
        const auto wedge =
            static_cast<std::size_t>(std::ranges::find(plans, "wedge", &ObjectPlan::object) - plans.begin());
        ASSERT_TRUE(plans.at(wedge).why.rejected);
        at.visit.act(ToggleExpert{});
        for (const Language& language : at.words.languages())
            for (const bool open : {false, true}) {
                at.visit.act(ChooseLanguage{language.code});
                if (open)
                    at.visit.act(OpenObject{wedge, at.drawn().objects[wedge].material.material.name});
                else
                    at.visit.act(ClosePanel{});
                at.lay();
                const Widget& panel = *at.desk.find(Part::expert_panel);
                EXPECT_FALSE(paint(panel, at.desk.layout.unit_px).text_cut)
                    << language.code << ' ' << screen.width_px << 'x' << screen.height_px << ' ' << open;
            }
    }
}

TEST(Desk, TellsTechniciansBriefly) {
    TestDesk at;
    at.notice = at.words.text("en", "notice.refused",
                              {{"error", "cannot read /srv/museum/kiosk.ini:12: strength = -1 is below 0"}});
    at.lay();
    EXPECT_EQ(at.desk.find(Part::notice)->text,
              at.words.text("en", "notice.refused", {{"error", "kiosk.ini:12: strength = -1 is below 0"}}));
}

} // namespace
} // namespace metamer
