// [kiosk], [tour.N] and what of [display] is for the kiosk.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "exhibit/support.h"

namespace metamer {
namespace {

using testing::HasSubstr;

std::string refusal(const std::string& text) {
    return error_of([&] { exhibit_of(text); });
}

TEST(KioskSettings, DefaultsAreTheTables) {
    const KioskSetting kiosk = exhibit_of("[kiosk]\n").kiosk;
    EXPECT_EQ(kiosk.idle_s, 60);
    EXPECT_EQ(kiosk.language, "en");
    EXPECT_TRUE(kiosk.strings.empty());
    EXPECT_FALSE(kiosk.night);
    EXPECT_EQ(kiosk.pixel_shift_px, 4);
    EXPECT_EQ(kiosk.watch_s, 60);
    EXPECT_TRUE(kiosk.fullscreen);
    EXPECT_EQ(kiosk.rotation_deg, 0);
    EXPECT_EQ(kiosk.diagonal_in, 0);
    EXPECT_TRUE(kiosk.tour.empty());
    std::vector<std::string> names;
    for (const LampSetting& lamp : kiosk.lamps)
        names.push_back(lamp.lamp.name);
    EXPECT_THAT(names, testing::ElementsAre("E", "D65", "A2800", "F11", "white-LED", "krypton"));
    EXPECT_EQ(kiosk.booth_left, 1u);
    EXPECT_EQ(kiosk.booth_right, 3u);
}

TEST(KioskSettings, NoShelfWhereNobodyAsks) {
    const Exhibit plain = exhibit_of("[scene]\nkind = crayons\n");
    EXPECT_TRUE(plain.kiosk.lamps.empty());
    const Exhibit asked = parse_exhibit("[scene]\nkind = crayons\n", "k.ini", config_folder(),
                                        with_quick_rows(), nullptr, Use::kiosk);
    EXPECT_EQ(asked.kiosk.lamps.size(), 6u);
    EXPECT_EQ(asked.atlas.lamps[static_cast<std::size_t>(asked.kiosk.lamps.back().key)].name, "krypton")
        << "each has its row";
}

TEST(KioskSettings, AreTakenOver) {
    const KioskSetting kiosk =
        exhibit_of("[display]\nfullscreen = no\nrotation = 270\ndiagonal = 7\n"
                   "[kiosk]\nidle_s = 20\nlanguage = pt-BR\nstrings = words\nlamps = F2, D65\n"
                   "booth.left = f2\nbooth.right = D65\nnight = 22:00 - 06:30\npixel_shift = 0\n"
                   "watch_s = 0\n")
            .kiosk;
    EXPECT_FALSE(kiosk.fullscreen);
    EXPECT_EQ(kiosk.rotation_deg, 270);
    EXPECT_EQ(kiosk.diagonal_in, 7);
    EXPECT_EQ(kiosk.idle_s, 20);
    EXPECT_EQ(kiosk.language, "pt-BR");
    EXPECT_EQ(kiosk.strings, config_folder() / "words");
    EXPECT_EQ(kiosk.lamps.size(), 2u);
    EXPECT_EQ(kiosk.booth_left, 0u);
    EXPECT_EQ(kiosk.booth_right, 1u);
    ASSERT_TRUE(kiosk.night);
    EXPECT_EQ(kiosk.night->from_min, 22 * 60);
    EXPECT_EQ(kiosk.night->to_min, 6 * 60 + 30);
    EXPECT_EQ(kiosk.pixel_shift_px, 0);
    EXPECT_EQ(kiosk.watch_s, 0);
}

/// What the booth of a shelf starts with, as "left right".
std::string booth_of(const std::string& shelf, const std::string& written = "") {
    const KioskSetting kiosk = exhibit_of("[kiosk]\nlamps = " + shelf + "\n" + written).kiosk;
    return kiosk.lamps[kiosk.booth_left].lamp.name + " " + kiosk.lamps[kiosk.booth_right].lamp.name;
}

TEST(KioskSettings, TheBoothStartsWithTwoLampsWhereThereAreTwo) {
    EXPECT_EQ(booth_of("F1"), "F1 F1");
    EXPECT_EQ(booth_of("F1, F2"), "F1 F2");
    EXPECT_EQ(booth_of("F1, F2, F3"), "F2 F3");
    EXPECT_EQ(booth_of("F1, F2, F3, F4"), "F2 F4");
    EXPECT_EQ(booth_of("F1, F2, F3, F4, F5"), "F2 F4");
    EXPECT_EQ(booth_of("F1, F2", "booth.left = F2\n"), "F2 F1");
    EXPECT_EQ(booth_of("F1, F2", "booth.right = F1\n"), "F2 F1");
    EXPECT_EQ(booth_of("F1, F2", "booth.right = F2\n"), "F1 F2");
    EXPECT_EQ(booth_of("F1, F2, F3", "booth.left = F3\n"), "F3 F2");
    EXPECT_EQ(booth_of("F1, F2, F3, F4", "booth.left = F4\n"), "F4 F3");
    EXPECT_EQ(booth_of("F1, F2, F3, F4", "booth.right = F2\n"), "F1 F2");
    EXPECT_EQ(booth_of("F1, F2, F3, F4", "booth.left = F3\nbooth.right = F3\n"), "F3 F3") << "as written";
}

TEST(KioskSettings, NoLampThatNoEyeAdaptsTo) {
    const auto refusal_for = [](Use use, const std::string& adaptation) {
        return error_of([&] {
            parse_exhibit("[display]\nadaptation = " + adaptation + "\n[kiosk]\nlamps = E, NIST-LPS, F11\n",
                          "k.ini", config_folder(), with_quick_rows(), nullptr, use);
        });
    };
    EXPECT_EQ(refusal_for(Use::kiosk, "bradford"),
              "cannot read k.ini:4: lamps: NIST-LPS does not go with adaptation = bradford (k.ini:2): its "
              "light does not excite all three cone responses of the Bradford transform");
    EXPECT_EQ(refusal_for(Use::kiosk, "none"), "no error");
    EXPECT_EQ(refusal_for(Use::frame, "bradford"), "no error") << "the shelf is not drawn";
    EXPECT_EQ(error_of([] {
                  parse_exhibit("[display]\nadaptation = bradford\n", "k.ini", config_folder(),
                                with_quick_rows(), nullptr, Use::kiosk);
              }),
              "no error")
        << "the shelf that nobody wrote";
}

TEST(Tour, StepsAreTakenOver) {
    const Exhibit exhibit = exhibit_of("[scene]\nkind = loaf\nmaterials = crayons\n[kiosk]\nlamps = E, F11\n"
                                       "[tour.1]\nlamp = F11\nsplit = 0.25\nseconds = 5\ncaption = Look\n"
                                       "caption.de = Schau\n[tour.2]\nmaterials = colorchecker\n"
                                       "[tour.3]\nmaterials = colorchecker\n");
    const std::vector<TourStep>& tour = exhibit.kiosk.tour;
    ASSERT_EQ(tour.size(), 3u);
    EXPECT_EQ(tour[0].lamp, 1u);
    EXPECT_EQ(tour[0].split, 0.25);
    EXPECT_EQ(tour[0].seconds, 5);
    EXPECT_EQ(tour[0].caption("de"), "Schau");
    EXPECT_EQ(tour[0].caption("fr"), "Look") << "the common one";
    EXPECT_EQ(tour[0].scene, nullptr);
    EXPECT_FALSE(tour[1].lamp);
    EXPECT_EQ(tour[1].seconds, 8);
    EXPECT_EQ(tour[1].caption("en"), "");
    ASSERT_TRUE(tour[1].scene);
    EXPECT_EQ(tour[1].scene->objects.size(), 24u);
    EXPECT_TRUE(tour[1].scene->kiosk.tour.empty());
    EXPECT_EQ(tour[1].scene->kiosk.lamps.size(), 2u) << "the shelf is the same";
    EXPECT_EQ(tour[1].scene, tour[2].scene) << "loaded once";
}

TEST(KioskSettings, AreRefusedWithTheirPlace) {
    EXPECT_EQ(refusal("[kiosk]\nidle_s = 1\n"),
              "cannot read k.ini:2: idle_s = 1 is below 5; it may be 5 .. 3600 s");
    EXPECT_EQ(refusal("[kiosk]\nlanguage = ../en\n"),
              "cannot read k.ini:2: language = ../en names no language: letters and -, as in pt-BR");
    for (const char* hours :
         {"", "22", "22:00", "24:00-06:00", "22:60-06:00", "1:0-2:0", "22:00-06:00-07:00"})
        EXPECT_EQ(refusal(std::string("[kiosk]\nnight = ") + hours + "\n"),
                  std::string("cannot read k.ini:2: night = ") + hours +
                      " is not from-to, as in 22:00-07:00");
    EXPECT_EQ(refusal("[kiosk]\nnight = 06:00-06:00\n"),
              "cannot read k.ini:2: night = 06:00-06:00 would be dark all day");
    EXPECT_EQ(refusal("[kiosk]\nlamps = E,, F2\n"),
              "cannot read k.ini:2: lamps = E,, F2 has nothing between two commas");
    EXPECT_EQ(refusal("[kiosk]\nlamps = E, F2, e\n"), "cannot read k.ini:2: lamps = E, F2, e has e twice");
    EXPECT_THAT(refusal("[kiosk]\nlamps = E, F22\n"), HasSubstr("k.ini:2: lamps: F22: "));
    EXPECT_THAT(refusal("[kiosk]\nlamps = F1,F2,F3,F4,F5,F6,F7,F8,F9,F10,F11,F12,E\n"),
                HasSubstr("is 13 lamps; at most 12 fit on the shelf"));
    EXPECT_EQ(refusal("[kiosk]\nbooth.left = F2\n"),
              "cannot read k.ini:2: booth.left = F2 is not on the shelf; add it to [kiosk] lamps");
    EXPECT_THAT(refusal("[display]\nrotation = 45\n"), HasSubstr("rotation = 45 is none of 0, 90, 180, 270"));
}

TEST(Tour, IsRefusedWithItsPlace) {
    EXPECT_EQ(refusal("[tour.1]\nlamp = F2\n"),
              "cannot read k.ini:2: lamp = F2 is not on the shelf; add it to [kiosk] lamps");
    EXPECT_EQ(
        refusal("[tour.2]\nseconds = 5\n"),
        "cannot read k.ini:1: there is no [tour.1]; steps of the tour are numbered from 1 without gaps");
    EXPECT_THAT(refusal("[scene]\nkind = loaf\n[tour.1]\nmaterials = crayon-pink\n"),
                HasSubstr("k.ini:4: materials = crayon-pink"));
    EXPECT_THAT(refusal("[tour.65]\nseconds = 5\n"), HasSubstr("[tour.1] .. [tour.64]"));
    EXPECT_THAT(refusal("[tuor.1]\nseconds = 5\n"), HasSubstr("did you mean [tour.1]?"));
    EXPECT_THAT(refusal("[tour.1]\ncaption. = Look\n"), HasSubstr("unknown key \"caption.\""));
    EXPECT_THAT(refusal("[tour.1]\ncaption.d/e = Schau\n"), HasSubstr("names no language"));
}

TEST(Tour, CanBeSetFromTheCommandLine) {
    const Exhibit exhibit = exhibit_of("[kiosk]\n", {"tour.1.caption.de=Hallo", "tour.1.seconds=3"});
    ASSERT_EQ(exhibit.kiosk.tour.size(), 1u);
    EXPECT_EQ(exhibit.kiosk.tour[0].caption("de"), "Hallo");
    EXPECT_EQ(exhibit.kiosk.tour[0].seconds, 3);
}

} // namespace
} // namespace metamer
