// The real-valued rows behind the levels.
#include <gmock/gmock.h>

#include "atlas/material_fit.h"
#include "atlas/samples.h"
#include "spectra/library.h"

namespace metamer {
namespace {

TEST(Projected, KeepsWhatIsConstantOrLinear) {
    FineValues flat, slope;
    flat.fill(0.25);
    for (std::size_t k = 0; k < slope.size(); ++k)
        slope[k] = kReferenceGrid.wavelength_nm(k);
    const RowValues of_flat = projected(flat), of_slope = projected(slope);
    for (std::size_t i = 0; i < kIntervals; ++i)
        EXPECT_NEAR(of_flat[i], 0.25, 1e-12) << i;
    // Within an interval the observer slopes too: a tenth of a step is not far.
    for (std::size_t i = 1; i + 1 < kIntervals; ++i)
        EXPECT_NEAR(of_slope[i], kThesisGrid.wavelength_nm(i), 0.6) << i;
    EXPECT_GT(of_slope[63], 710); // all beyond 700 nm weighs in
    EXPECT_LT(of_slope[0], 386);
}

TEST(FitLamp, WhiteComesOutAsAt1Nm) {
    for (const char* name : {"A", "D65", "F2", "F11", "krypton"}) {
        const LampPower power = lamp_power(find_lamp(name).spectrum);
        const RowFit fit = fit_lamp(power);
        FineValues white;
        white.fill(1);
        const Xyz exact = fine_sum(power.fine, white), row = weighted_sum(fit.best);
        EXPECT_NEAR(row.x / row.y, exact.x / exact.y, 2e-4) << name;
        EXPECT_NEAR(row.z / row.y, exact.z / exact.y, 2e-4) << name;
    }
}

TEST(FitLamp, IsNeverNegative) {
    for (const Lamp& lamp : library_lamps()) {
        const RowFit fit = fit_lamp(lamp_power(lamp.spectrum));
        EXPECT_THAT(fit.best, testing::Each(testing::Ge(0))) << lamp.name;
    }
}

TEST(FitMaterial, StaysWithin0And1) {
    for (const char* name : {"single-550", "empirical-4", "crayon-black", "crayon-white"}) {
        const RowFit fit = fit_material(find_material(name).spectrum);
        EXPECT_THAT(fit.best, testing::Each(testing::AllOf(testing::Ge(0), testing::Le(1)))) << name;
    }
}

// A deviation that the eye sees more costs more: the same step in the dark and in the light, in the middle of
// the spectrum and at its end.
TEST(FitMaterial, TheFormWeighsAsTheEyeDoes) {
    const auto cost = [](double level, std::size_t i) {
        return fit_material(flat_material("", level).spectrum).form.g[i][i];
    };
    EXPECT_GT(cost(0.05, 34), 4 * cost(0.5, 34));
    EXPECT_GT(cost(0.5, 34), 2 * cost(0.5, 62));
}

TEST(Priors, AreWhatTheySay) {
    for (const PriorLamp& lamp : prior_lamps()) {
        double fine = 0, row = 0;
        for (const Xyz& at : lamp.fine)
            fine += at.y;
        for (const Xyz& at : lamp.interval)
            row += at.y;
        EXPECT_NEAR(fine, 1, 1e-12);
        EXPECT_NEAR(row, 1, 1e-12);
    }
    for (const PriorMaterial& material : prior_materials()) {
        EXPECT_THAT(material.fine, testing::Each(testing::AllOf(testing::Ge(0), testing::Le(1))));
        EXPECT_GT(material.weight, 0);
    }
}

} // namespace
} // namespace metamer
