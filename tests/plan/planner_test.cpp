#include "plan/planner.h"

#include <gmock/gmock.h>

#include "plan/planned.h"

namespace metamer::test {
namespace {

using testing::HasSubstr;

const std::string kMedia = "[scene]\nkind = media\n";
const std::string kLineLamp = "[lamp.1]\nspectrum = F11\n";

TEST(Planner, LightThatStaysLinearIsFolded) {
    for (const char* kind : {"loaf", "crayons", "patches", "still-life", "corner"}) {
        const Planned planned("[scene]\nkind = " + std::string(kind) + "\n" + kLineLamp);
        for (const ObjectPlan& object : planned.plan.halves.at(0).objects) {
            EXPECT_EQ(object.method, Method::folded) << kind << ' ' << object.object;
            EXPECT_LT(object.delta_e_bound, 0.02) << kind << ' ' << object.object;
            EXPECT_THAT(in_english(object.why), HasSubstr("light stays linear"));
            EXPECT_FALSE(object.asked);
        }
    }
}

// A table's fetches per lamp cost more than a table of three numbers, fetched once: under equal energy,
// where the product is exact, it is what is left to do.
TEST(Planner, KeyMapsUnderSeveralLampsOfEqualEnergyTakeTheProduct) {
    std::string text =
        "[scene]\nkind = still-life\nmaterials = crayons\n[object.ball]\nkey_map = maps/beach-ball.png\n";
    for (int lamp = 1; lamp <= 4; ++lamp)
        text += "[lamp." + std::to_string(lamp) + "]\nspectrum = E\n";
    const Planned planned(text);
    EXPECT_EQ(planned.of("ball").method, Method::tristimulus) << in_english(planned.of("ball").why);
    EXPECT_EQ(planned.of("table").method, Method::folded);
    for (const char* lamp : {"F11", "A2800", "krypton", "D65"})
        text.replace(text.find("= E\n"), 3, "= " + std::string(lamp));
    EXPECT_EQ(Planned(text).of("ball").method, Method::folded) << "line lamps leave three numbers far behind";
}

TEST(Planner, MediaAreReducedAndATighterToleranceTakesMoreTaps) {
    const auto taps = [](const char* tolerance) {
        const Planned planned(kMedia + kLineLamp + "[accuracy]\ntolerance = " + tolerance + "\n");
        const ObjectPlan& wedge = planned.of("wedge");
        EXPECT_EQ(wedge.method, Method::reduced) << in_english(wedge.why);
        EXPECT_LE(wedge.delta_e_bound, planned.plan.tolerance);
        EXPECT_THAT(in_english(wedge.why), HasSubstr("thickness varies"));
        return wedge.taps.wavelength_nm.size();
    };
    EXPECT_EQ(taps("2"), 4u);
    EXPECT_LT(taps("2"), taps("0.05"));
}

// The count below the one that was chosen would not have held.
TEST(Planner, TheFewestTapsThatHoldAreTaken) {
    const Planned planned(kMedia + kLineLamp + "[accuracy]\ntolerance = 0.1\n");
    const std::size_t chosen = planned.of("wedge").taps.wavelength_nm.size();
    ASSERT_GT(chosen, 4u);
    int fewer = 0;
    for (const int count : kTapCounts)
        if (static_cast<std::size_t>(count) < chosen)
            fewer = count;
    const Planned asked(kMedia + kLineLamp + "[object.wedge]\nmethod = reduced\n[accuracy]\ntaps = " +
                        std::to_string(fewer) + "\n");
    EXPECT_GT(asked.of("wedge").delta_e_bound, 0.1);
}

TEST(Planner, WhatIsAskedForIsTakenWhateverItErrsBy) {
    const Planned planned("[scene]\nkind = patches\nmaterials = cc-cyan\n[lamp.1]\nspectrum = NIST-LPS\n"
                          "[accuracy]\nmethod = rgb\n");
    const ObjectPlan& patch = planned.of("patch-1");
    EXPECT_TRUE(patch.asked);
    EXPECT_EQ(patch.method, Method::rgb);
    EXPECT_GT(patch.delta_e_bound, 5);
    EXPECT_EQ(in_english(patch.worst), "NIST-LPS on cc-cyan");
    EXPECT_THAT(in_english(patch.why), HasSubstr("the exhibit asks for it"));
    EXPECT_THAT(in_english(patch.why), HasSubstr("(NIST-LPS on cc-cyan)"));
}

TEST(Planner, TheObjectsChoiceBeatsTheHalfsAndTheHalfsTheExhibits) {
    const Planned planned(
        "[scene]\nkind = patches\nmaterials = cc-red, cc-blue, cc-green\n[accuracy]\nmethod = packed\n"
        "[object.patch-1]\nmethod = spectral\n[object.patch-2]\nmethod = auto\n"
        "[compare]\nleft.method = rgb\n");
    EXPECT_EQ(planned.of("patch-1", 0).method, Method::spectral);
    EXPECT_EQ(planned.of("patch-2", 0).method, Method::folded);
    EXPECT_EQ(planned.of("patch-3", 0).method, Method::rgb);
    EXPECT_EQ(planned.of("patch-3", 1).method, Method::packed);
    EXPECT_FALSE(planned.of("patch-2", 1).asked);
}

TEST(Planner, AskedTapsAreTaken) {
    const Planned planned(kMedia + "[object.wedge]\nmethod = reduced\n[accuracy]\ntaps = 6\n");
    EXPECT_EQ(planned.of("wedge").taps.wavelength_nm.size(), 6u);
}

TEST(Planner, AConstantCannotBeAMedium) {
    EXPECT_EQ(error_of([] { Planned(kMedia + "[object.wedge]\nmethod = folded\n"); }),
              "cannot draw object \"wedge\" of k.ini: method folded is a constant, and its medium's "
              "thickness varies");
}

// 4096 times a row of entries above 15.99 in sum is infinite in half, and infinity less infinity is no
// number.
TEST(Planner, AMatrixThatOverflowsInHalfIsLeftToSumsOnTheCpu) {
    const std::string great = "[display]\nmatrix = 20 -10 0 0 1 0 0 0 1\n[scene]\nkind = patches\n"
                              "materials = cc-red\n";
    EXPECT_EQ(error_of([&] { Planned(great + "[accuracy]\nmethod = spectral\n", 10); }),
              "cannot draw object \"patch-1\" of k.ini: this GPU computes in half precision, where method "
              "spectral overflows with so great a matrix; folded and reduced do not");
    EXPECT_NO_THROW(Planned(great + "[accuracy]\nmethod = spectral\n", 23));
    EXPECT_EQ(Planned(great, 10).of("patch-1").method, Method::folded);
}

// Half precision, 64 or 32 terms: nothing is as near as a hundredth.
TEST(Planner, AToleranceThatNothingHoldsIsRefusedByName) {
    const std::string message =
        error_of([] { Planned(kMedia + kLineLamp + "[accuracy]\ntolerance = 0.01\n", 10); });
    EXPECT_THAT(message,
                testing::MatchesRegex(
                    "cannot plan object \"wedge\" of k\\.ini: no method holds a CIEDE2000 of 0\\.01; "
                    "(reduced|packed|spectral) comes nearest and errs by [0-9.]+ \\(F11 on rgb:FFFFFF "
                    "through glass-cobalt, thickness [0-9.]+\\)"));
}

TEST(Planner, HalfPrecisionErrsMore) {
    const Planned fine(kLineLamp), coarse(kLineLamp, 10);
    for (std::size_t i = 0; i < fine.exhibit.objects.size(); ++i) {
        const ObjectPlan &a = fine.plan.halves[0].objects[i], &b = coarse.plan.halves[0].objects[i];
        EXPECT_LT(a.delta_e_bound, b.delta_e_bound) << a.object;
    }
    EXPECT_EQ(coarse.plan.fragment_bits, 10);
    const std::string loop = kLineLamp + "[accuracy]\nmethod = spectral\n";
    EXPECT_GT(Planned(loop, 10).of("crayon-1").delta_e_bound, 2 * Planned(loop).of("crayon-1").delta_e_bound);
}

TEST(Planner, WhyIsOneSentence) {
    for (const std::string& text :
         {kMedia, kMedia + kLineLamp, std::string("[scene]\nkind = ramp\n"),
          std::string("[scene]\nkind = corner\n"), kLineLamp + "[compare]\nleft.method = spectral\n"}) {
        const Planned planned(text);
        for (const HalfPlan& half : planned.plan.halves)
            for (const ObjectPlan& object : half.objects) {
                const std::string why = in_english(object.why);
                EXPECT_FALSE(why.empty());
                EXPECT_EQ(why.find_first_of("\n\r"), std::string::npos) << why;
                EXPECT_EQ(why.find(". "), std::string::npos) << why;
                EXPECT_NE(why.back(), '.') << why;
            }
    }
}

TEST(Planner, ObjectsKeepTheExhibitsOrder) {
    const Planned planned("[scene]\nkind = still-life\n[compare]\n");
    ASSERT_EQ(planned.plan.halves.size(), 2u);
    for (const HalfPlan& half : planned.plan.halves)
        for (std::size_t i = 0; i < planned.exhibit.objects.size(); ++i)
            EXPECT_EQ(half.objects.at(i).object, planned.exhibit.objects[i].name);
}

} // namespace
} // namespace metamer::test
