#include "color/observer.h"

#include <cmath>
#include <fstream>
#include <gtest/gtest.h>
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
