#include "color/observer.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <gtest/gtest.h>
#include <numeric>
#include <sstream>

namespace metamer {
namespace {

// Sums over 360..830 nm at 1 nm, ISO/CIE 11664-1:2019 (x, y, z: 106.8652, 106.8569, 106.8922 to four digits).
TEST(Observer, SumsAreThePublishedOnes) {
    double x = 0, y = 0, z = 0;
    for (const ColorMatching& row : cie_1931_2deg()) {
        x += row.x;
        y += row.y;
        z += row.z;
    }
    EXPECT_NEAR(x, 106.8654694, 1e-4);
    EXPECT_NEAR(y, 106.8569171, 1e-4);
    EXPECT_NEAR(z, 106.8922513, 1e-4);
}

// The thesis misprints four cells of the table; these are the standard's (shared notes of the tables'
// comparison).
TEST(Observer, HasTheStandardsValuesWhereTheThesisMisprints) {
    const auto row = [](int nm) { return cie_1931_2deg()[static_cast<std::size_t>(nm - 360)]; };
    EXPECT_NEAR(row(555).y, 1.0000, 5e-5);
    EXPECT_NEAR(row(595).x, 1.0567, 5e-5);
    EXPECT_NEAR(row(740).y, 0.0002492, 1e-7);
    EXPECT_NEAR(row(775).x, 0.0000587, 1e-7);
}

TEST(Observer, SampledOneIsDividedByItsGreatestValue) {
    const GridObserver o = sampled_observer();
    EXPECT_DOUBLE_EQ(o.z[12], 1); // 445 nm
    EXPECT_NEAR(o.x[42], 1.0567 / 1.7826, 1e-12);
    EXPECT_NEAR(o.y[34], 1.0 / 1.7826, 1e-9); // 555 nm
    EXPECT_NEAR(o.y[0], 0.000064 / 1.7826, 1e-12);
    EXPECT_NEAR(o.x[63], 0.011359 / 1.7826, 1e-6);
}

// Nothing of the table is lost, and its greatest weight is 1.
TEST(Observer, WeightsSumToTheTable) {
    const GridObserver o = weighted_observer();
    EXPECT_DOUBLE_EQ(o.z[12], 1);
    const auto sum = [](const auto& values) { return std::accumulate(values.begin(), values.end(), 0.0); };
    EXPECT_NEAR(sum(o.x) / sum(o.y), 106.8654694 / 106.8569171, 1e-9);
    EXPECT_NEAR(sum(o.z) / sum(o.y), 106.8922513 / 106.8569171, 1e-9);
    EXPECT_GT(*std::min_element(o.y.begin(), o.y.end()), 0);
}

// A weight is the table's moment about its interval: sums of linear functions come out exact inside the grid.
TEST(Observer, WeightsKeepCentroids) {
    const auto table = cie_1931_2deg();
    const GridObserver o = weighted_observer();
    double weight = 0, moment = 0, exact_weight = 0, exact_moment = 0;
    for (std::size_t i = 0; i < kIntervals; ++i) {
        weight += o.y[i];
        moment += o.y[i] * kThesisGrid.wavelength_nm(i);
    }
    for (std::size_t k = 0; k < table.size(); ++k) {
        exact_weight += table[k].y;
        exact_moment += table[k].y * std::clamp(kReferenceGrid.wavelength_nm(k), 385.0, 700.0);
    }
    EXPECT_NEAR(moment / weight, exact_moment / exact_weight, 1e-9);
}

// By hand: 700 nm takes 5/5 .. 1/5 of 700 .. 696 nm and all beyond; against 695 nm, which has no tail.
TEST(Observer, WeightsOutsideTheGridFoldOntoItsEnds) {
    const auto table = cie_1931_2deg();
    const auto x_at = [&](std::size_t nm) { return table[nm - 360].x; };
    double tail = 0;
    for (std::size_t nm = 701; nm <= 830; ++nm)
        tail += x_at(nm);
    const double end =
        x_at(700) + 0.8 * x_at(699) + 0.6 * x_at(698) + 0.4 * x_at(697) + 0.2 * x_at(696) + tail;
    const double next = x_at(695) + 0.8 * (x_at(694) + x_at(696)) + 0.6 * (x_at(693) + x_at(697)) +
                        0.4 * (x_at(692) + x_at(698)) + 0.2 * (x_at(691) + x_at(699));
    const GridObserver o = weighted_observer();
    EXPECT_NEAR(o.x[63] / o.x[62], end / next, 1e-9);
}

TEST(Observer, AWavelengthIsSharedByTheIntervalsBesideIt) {
    const auto expect = [](double wavelength_nm, std::size_t interval, double share_of_next) {
        EXPECT_EQ(hat_share(wavelength_nm).interval, interval) << wavelength_nm;
        EXPECT_NEAR(hat_share(wavelength_nm).share_of_next, share_of_next, 1e-12) << wavelength_nm;
    };
    expect(360, 0, 0);
    expect(385, 0, 0);
    expect(386, 0, 0.2);
    expect(589.3, 40, 0.86);
    expect(700, 62, 1);
    expect(830, 62, 1);
}

TEST(Observer, EqualsTheSharedTable) {
    std::ifstream in(METAMER_SOURCE_DIR "/../shared/spectra/observers_1nm.csv");
    if (!in)
        return; // a second opinion, where it is at hand
    std::string line;
    int rows = 0;
    while (std::getline(in, line)) {
        if (line.empty() || !std::isdigit(static_cast<unsigned char>(line[0])))
            continue;
        std::istringstream fields(line);
        double nm, x, y, z;
        char comma;
        fields >> nm >> comma >> x >> comma >> y >> comma >> z;
        const auto& row = cie_1931_2deg()[static_cast<std::size_t>(nm - 360)];
        EXPECT_EQ(row.x, x) << nm;
        EXPECT_EQ(row.y, y) << nm;
        EXPECT_EQ(row.z, z) << nm;
        ++rows;
    }
    EXPECT_EQ(rows, 471);
}

} // namespace
} // namespace metamer
