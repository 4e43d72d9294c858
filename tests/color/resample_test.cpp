#include "color/resample.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numeric>

namespace metamer {
namespace {

double energy(const std::vector<double>& power, const Grid& grid) {
    return std::accumulate(power.begin(), power.end(), 0.0) * grid.step_nm;
}

double centroid_nm(const std::vector<double>& power, const Grid& grid) {
    double sum = 0, weighted = 0;
    for (std::size_t i = 0; i < power.size(); ++i) {
        sum += power[i];
        weighted += power[i] * grid.wavelength_nm(i);
    }
    return weighted / sum;
}

Curve sampled(double first_nm, double last_nm, double step_nm, double (*f)(double)) {
    Curve curve;
    for (double w = first_nm; w <= last_nm + 1e-9; w += step_nm) {
        curve.wavelength_nm.push_back(w);
        curve.value.push_back(f(w));
    }
    return curve;
}

double bell(double nm) {
    return std::exp(-0.5 * std::pow((nm - 543.2) / 12, 2));
}
constexpr double kBellArea = 12 * 2.5066282746310002; // sigma sqrt(2 pi)

TEST(Resample, SamplesOnTheGridPassUnchanged) {
    const Curve curve = sampled(380, 780, 5, [](double nm) { return nm - 300; });
    const auto power = resample(LampSpectrum{curve, {}}, kThesisGrid);
    for (std::size_t i = 0; i < kIntervals; ++i)
        EXPECT_NEAR(power[i], kThesisGrid.wavelength_nm(i) - 300, 1e-9);
}

TEST(Resample, CoarseSamplesAreInterpolated) {
    const Curve curve = sampled(380, 780, 10, [](double nm) { return nm - 300; });
    const auto power = resample(LampSpectrum{curve, {}}, kThesisGrid);
    for (std::size_t i = 0; i < kIntervals; ++i)
        EXPECT_NEAR(power[i], kThesisGrid.wavelength_nm(i) - 300, 1e-9);
}

TEST(Resample, ALineBetweenTwoIntervalsIsSharedByBoth) {
    const auto power = resample(LampSpectrum{{}, {{589.3, 10}}}, kThesisGrid);
    const std::size_t i = 40; // 585 nm; 589.3 is 0.86 of the way to 590
    EXPECT_NEAR(power[i], 10 * 0.14 / 5, 1e-12);
    EXPECT_NEAR(power[i + 1], 10 * 0.86 / 5, 1e-12);
    EXPECT_NEAR(energy(power, kThesisGrid), 10, 1e-12);
    EXPECT_NEAR(centroid_nm(power, kThesisGrid), 589.3, 1e-9);
}

TEST(Resample, ALineOnTheGridIsOneInterval) {
    const auto power = resample(LampSpectrum{{}, {{700, 5}}}, kThesisGrid);
    EXPECT_DOUBLE_EQ(power[63], 1);
    EXPECT_DOUBLE_EQ(power[62], 0);
}

TEST(Resample, KeepsEnergyAndCentroidAtAnyStep) {
    for (double step : {0.1, 0.5, 1.0, 2.0, 3.3, 5.0, 7.0}) {
        const auto power = resample(LampSpectrum{sampled(450.7, 640, step, bell), {}}, kThesisGrid);
        EXPECT_NEAR(energy(power, kThesisGrid), kBellArea, 2e-3 * kBellArea) << step;
        EXPECT_NEAR(centroid_nm(power, kThesisGrid), 543.2, 0.05) << step;
    }
}

TEST(Resample, KeepsEnergyAndCentroidOfIrregularSamples) {
    Curve curve;
    double expected = 0, moment = 0;
    for (double w = 470; w < 620; w += 0.3 + 0.9 * std::abs(std::sin(w)) + 0.02 * (w - 470)) {
        curve.wavelength_nm.push_back(w);
        curve.value.push_back(bell(w));
    }
    for (std::size_t k = 1; k + 1 < curve.wavelength_nm.size(); ++k) {
        const double dw = (curve.wavelength_nm[k + 1] - curve.wavelength_nm[k - 1]) / 2;
        expected += curve.value[k] * dw;
        moment += curve.value[k] * dw * curve.wavelength_nm[k];
    }
    const auto power = resample(LampSpectrum{curve, {}}, kThesisGrid);
    EXPECT_NEAR(energy(power, kThesisGrid), expected, 1e-6 * expected);
    EXPECT_NEAR(centroid_nm(power, kThesisGrid), moment / expected, 1e-6);
}

TEST(Resample, LampsAreDarkOutsideTheirRange) {
    const auto power = resample(LampSpectrum{{{500, 505, 510}, {1, 1, 1}}, {}}, kThesisGrid);
    EXPECT_EQ(power[22], 0); // 495
    EXPECT_EQ(power[23], 1); // 500
    EXPECT_EQ(power[26], 0); // 515
}

TEST(Resample, MaterialsHoldTheirEnds) {
    const auto mean = resample(MaterialSpectrum{{{500, 600}, {0.2, 0.8}}}, kThesisGrid);
    EXPECT_DOUBLE_EQ(mean[0], 0.2);
    EXPECT_DOUBLE_EQ(mean[63], 0.8);
    EXPECT_NEAR(mean[33], 0.5, 1e-12); // 550
}

// 500 nm lies before the first sample: what the samples beside it say of the slope is not its affair.
TEST(Resample, MaterialsHoldTheirEndsBetweenIntervalsToo) {
    const auto mean = resample(
        MaterialSpectrum{sampled(502, 598, 1, [](double nm) { return (nm - 500) / 100; })}, kThesisGrid);
    EXPECT_DOUBLE_EQ(mean[23], 0.02); // 500
    EXPECT_DOUBLE_EQ(mean[43], 0.98); // 600
}

TEST(Resample, AFinelySampledConstantReflectanceStaysConstant) {
    const auto mean =
        resample(MaterialSpectrum{sampled(390.3, 690.1, 0.7, [](double) { return 0.37; })}, kThesisGrid);
    for (double r : mean)
        EXPECT_NEAR(r, 0.37, 1e-12);
}

TEST(LostShare, IsWhatLiesOutsideTheGrid) {
    EXPECT_DOUBLE_EQ(lost_share({{}, {{300, 3}, {500, 1}}}, kThesisGrid), 0.75);
    EXPECT_NEAR(lost_share({{}, {{382.5, 1}}}, kThesisGrid), 0.5, 1e-12); // half of it falls to 385 nm
    EXPECT_EQ(lost_share({{}, {{500, 1}}}, kThesisGrid), 0);
    EXPECT_EQ(lost_share({{{400, 500}, {0, 0}}, {}}, kThesisGrid), 0);
}

TEST(SampleLamp, IsScaledToItsPeak) {
    const SampledLamp lamp = sample_lamp({{}, {{500, 10}, {600, 40}}});
    EXPECT_DOUBLE_EQ(lamp.peak, 8); // 40 over an interval of 5 nm
    EXPECT_DOUBLE_EQ(lamp.emission.value[43], 1);
    EXPECT_DOUBLE_EQ(lamp.emission.value[23], 0.25);
}

TEST(SampleMaterial, IsClamped) {
    const Reflectance sampled = sample_material({{{385, 700}, {-0.5, 1.5}}});
    EXPECT_EQ(sampled.value[0], 0);
    EXPECT_EQ(sampled.value[63], 1);
    EXPECT_NEAR(sampled.value[30], -0.5 + 2.0 * 150 / 315, 1e-12);
}

TEST(SampleLamp, WithoutLightOnTheGridIsAllZero) {
    const SampledLamp lamp = sample_lamp({{}, {{300, 1}}});
    EXPECT_EQ(lamp.peak, 0);
    for (double e : lamp.emission.value)
        EXPECT_EQ(e, 0);
}

} // namespace
} // namespace metamer
