// From a file's steps to the grid: energy and centroid stay, whatever the step.
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "base/numbers.h"
#include "color/resample.h"
#include "spectra/csv.h"
#include "spectra/gaussian.h"
#include "spectra/library.h"

namespace metamer {
namespace {

struct Moments {
    double energy, centroid_nm;
};

Moments moments_on_grid(const LampSpectrum& lamp, const Grid& grid) {
    double energy = 0, moment = 0;
    const std::vector<double> power = resample(lamp, grid);
    for (std::size_t i = 0; i < power.size(); ++i) {
        energy += power[i] * grid.step_nm;
        moment += power[i] * grid.step_nm * grid.wavelength_nm(i);
    }
    return {energy, moment / energy};
}

// A band of 25 nm at 551.3 nm, written as a file at these wavelengths and read again.
LampSpectrum band_at(const std::vector<double>& wavelengths_nm) {
    std::string text = "wavelength_nm,band\n";
    for (const double w : wavelengths_nm)
        text += to_text(w) + "," + to_text(gaussian_at(w, 551.3, 25)) + "\n";
    return {parse_spectra(text, "band.csv", SpectrumKind::emission).curves.front(), {}};
}

std::vector<double> every(double step_nm) {
    std::vector<double> w;
    for (double at = 450; at <= 650; at += step_nm)
        w.push_back(at);
    return w;
}

constexpr double kBandEnergy = 25 * 1.0644670194312262; // sqrt(pi / (4 ln 2))

class Step : public testing::TestWithParam<double> {};

TEST_P(Step, KeepsEnergyAndCentroid) {
    for (const Grid& grid : {kThesisGrid, kReferenceGrid}) {
        const Moments m = moments_on_grid(band_at(every(GetParam())), grid);
        // Sums of a Gaussian of 25 nm at 10 nm and finer are exact to 1e-5.
        EXPECT_NEAR(m.energy, kBandEnergy, 1e-4 * kBandEnergy);
        EXPECT_NEAR(m.centroid_nm, 551.3, 1e-3);
    }
}

INSTANTIATE_TEST_SUITE_P(Resampling, Step, testing::Values(0.5, 1.0, 2.0, 4.0, 5.0, 10.0));

TEST(Resampling, KeepsEnergyAndCentroidOfIrregularSteps) {
    std::vector<double> w;
    double at = 450;
    for (int k = 0; at <= 650; ++k, at += 0.7 + 1.6 * std::abs(std::sin(k)))
        w.push_back(at);
    const Moments m = moments_on_grid(band_at(w), kThesisGrid);
    EXPECT_NEAR(m.energy, kBandEnergy, 2e-3 * kBandEnergy);
    EXPECT_NEAR(m.centroid_nm, 551.3, 0.02);
}

TEST(Resampling, SharesEveryLineOfKrypton) {
    const LampSpectrum krypton = find_lamp("krypton").spectrum;
    double energy = 0, moment = 0;
    for (const EmissionLine& line : krypton.lines) {
        energy += line.power;
        moment += line.power * line.wavelength_nm;
    }
    const Moments m = moments_on_grid(krypton, kReferenceGrid);
    EXPECT_NEAR(m.energy, energy, 1e-9 * energy);
    EXPECT_NEAR(m.centroid_nm, moment / energy, 1e-9 * m.centroid_nm);
}

} // namespace
} // namespace metamer
