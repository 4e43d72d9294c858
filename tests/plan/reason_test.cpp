// Why a method, word by word: `metamer plan` prints it.
#include "plan/reason.h"

#include <gtest/gtest.h>

#include "plan/planned.h"

namespace metamer::test {
namespace {

TEST(ReasonInEnglish, SaysEveryGround) {
    const auto said = [](Ground ground) {
        Reason reason;
        reason.ground = ground;
        reason.error = 0.123;
        reason.taps = 6;
        reason.worst = {"F11", "cc-red", "", 0};
        return in_english(reason);
    };
    EXPECT_EQ(said(Ground::asked), "the exhibit asks for it; it errs by up to 0.12 (F11 on cc-red)");
    EXPECT_EQ(said(Ground::constant), "light stays linear: its color under each lamp is a constant, summed "
                                      "before the frame; errs by at most 0.12");
    EXPECT_EQ(said(Ground::table), "light stays linear: a table gives the color of each key under each lamp, "
                                   "summed before the frame; errs by at most 0.12");
    EXPECT_EQ(said(Ground::product),
              "under these lamps three numbers are as good as spectra: the product errs by at most 0.12");
    EXPECT_EQ(said(Ground::taps), "6 wavelengths chosen for these lamps err by at most 0.12");
    EXPECT_EQ(said(Ground::thickness), "its thickness varies from pixel to pixel: 6 wavelengths chosen for "
                                       "these lamps err by at most 0.12");
    EXPECT_EQ(said(Ground::all), "nothing cheaper than all 64 wavelengths holds; it errs by at most 0.12");
}

TEST(ReasonInEnglish, SaysWhatWasNotGoodEnough) {
    Reason reason{.ground = Ground::taps, .error = 0.2, .taps = 8, .worst = {}, .rejected = {}};
    reason.rejected = {Method::reduced, 6, 1.5};
    EXPECT_EQ(in_english(reason), "8 wavelengths chosen for these lamps err by at most 0.20; reduced with 6, "
                                  "which is cheaper, would err by 1.50 or more");
    reason.rejected = {Method::rgb, 0, 12};
    EXPECT_EQ(in_english(reason), "8 wavelengths chosen for these lamps err by at most 0.20; rgb, which is "
                                  "cheaper, would err by 12.00 or more");
}

TEST(ReasonInEnglish, TellsErrorsNoFinerThanAnybodySees) {
    EXPECT_EQ(error_text(0), "0.001");
    EXPECT_EQ(error_text(0.0044), "0.004");
    EXPECT_EQ(error_text(0.0096), "0.01");
    EXPECT_EQ(error_text(0.5), "0.50");
    EXPECT_EQ(error_text(12.345), "12.35");
}

TEST(PixelInEnglish, NamesLampMaterialAndMedium) {
    EXPECT_EQ(in_english(PixelName{"F11", "cc-red", "", 0}), "F11 on cc-red");
    EXPECT_EQ(in_english(PixelName{"", "cc-red", "", 0}), "all lamps on cc-red");
    EXPECT_EQ(in_english(PixelName{"A2800", "white", "glass-blue", 2.5000001}),
              "A2800 on white through glass-blue, thickness 2.5");
}

// A reason's facts are those of the plan.
TEST(Reason, IsThePlans) {
    const Planned media("[scene]\nkind = media\n[lamp.1]\nspectrum = F11\n");
    const ObjectPlan& wedge = media.of("wedge");
    EXPECT_EQ(wedge.why.ground, Ground::thickness);
    EXPECT_EQ(wedge.why.error, wedge.delta_e_bound);
    EXPECT_EQ(static_cast<std::size_t>(wedge.why.taps), wedge.taps.wavelength_nm.size());
    ASSERT_TRUE(wedge.why.rejected);
    EXPECT_GT(wedge.why.rejected->error, media.plan.tolerance);
    const Planned asked("[scene]\nkind = patches\nmaterials = cc-red\n[accuracy]\nmethod = rgb\n");
    EXPECT_EQ(asked.of("patch-1").why.ground, Ground::asked);
    EXPECT_EQ(in_english(asked.of("patch-1").why.worst), in_english(asked.of("patch-1").worst));
    EXPECT_FALSE(asked.of("patch-1").why.rejected);
}

} // namespace
} // namespace metamer::test
