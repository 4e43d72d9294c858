// Absorbing media: Lambert-Beer law on Gaussian bands.
#include "spectra/absorption.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include <gtest/gtest.h>

#include "color/resample.h"
#include "spectra/library.h"

namespace metamer {
namespace {

TEST(Absorption, IsTenToTheMinusDensity) {
    const AbsorptionBand band{540, 40, 2};
    const MaterialSpectrum medium = transmittance({&band, 1});
    EXPECT_NEAR(value_at_held(medium.curve, 540), 0.01, 1e-15);
    EXPECT_NEAR(value_at_held(medium.curve, 560), 0.1, 1e-15) << "half the density at half the width";
    EXPECT_NEAR(value_at_held(medium.curve, 520), 0.1, 1e-15);
    EXPECT_NEAR(value_at_held(medium.curve, 800), 1, 1e-12);
}

TEST(Absorption, AddsDensitiesSoThatLayersMultiply) {
    const std::vector<AbsorptionBand> bands{{500, 60, 0.7}, {560, 80, 1.1}};
    const MaterialSpectrum both = transmittance(bands), one = transmittance({&bands[0], 1}),
                           other = transmittance({&bands[1], 1});
    for (double w = 360; w <= 830; ++w)
        EXPECT_NEAR(value_at_held(both.curve, w), value_at_held(one.curve, w) * value_at_held(other.curve, w),
                    1e-15);
}

TEST(Absorption, GoesWithTheThicknessAsAPower) {
    const std::vector<double> thin = resample(find_material("absorb:590:50:0.5").spectrum, kReferenceGrid),
                              thick = resample(find_material("absorb:590:50:1.5").spectrum, kReferenceGrid);
    for (std::size_t i = 0; i < thin.size(); ++i)
        EXPECT_NEAR(thick[i], std::pow(thin[i], 3), 1e-12);
}

TEST(Absorption, OfNoDensityIsClear) {
    const MaterialSpectrum clear = find_material("absorb:590:50:0").spectrum;
    for (const double t : clear.curve.value)
        EXPECT_EQ(t, 1);
}

TEST(Absorption, KeepsNarrowBands) {
    // What a band of 0.5 nm takes away, by Simpson's rule on its closed form, is missing on the grid.
    const AbsorptionBand band{541.7, 0.5, 1};
    const MaterialSpectrum medium = transmittance({&band, 1});
    EXPECT_TRUE(std::is_sorted(medium.curve.wavelength_nm.begin(), medium.curve.wavelength_nm.end(),
                               std::less_equal<>()));
    double missing = 0;
    constexpr int kSteps = 4000; // +- 2 nm
    for (int k = 0; k <= kSteps; ++k) {
        const double w = 539.7 + 4.0 * k / kSteps, simpson = k == 0 || k == kSteps ? 1 : k % 2 ? 4 : 2;
        missing += (1 - std::pow(10, -density_at({&band, 1}, w))) * simpson * 4.0 / kSteps / 3;
    }
    double on_grid = 0;
    for (const double t : resample(medium, kThesisGrid))
        on_grid += (1 - t) * kThesisGrid.step_nm;
    EXPECT_NEAR(on_grid, missing, 0.01 * missing);
}

} // namespace
} // namespace metamer
