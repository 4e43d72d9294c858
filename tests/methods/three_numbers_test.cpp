#include "methods/three_numbers.h"

#include <gtest/gtest.h>

#include "color/colorimetry.h"
#include "color/resample.h"

namespace metamer {
namespace {

// The grid ends at 700 nm and keeps every fifth value of the observer: a few units in the fourth place.
TEST(WhiteEmission, HasTheWhiteOfItsSpace) {
    for (const WorkingSpace& space : working_spaces()) {
        const Chromaticity c = chromaticity(lamp_xyz(white_emission(space), sampled_observer()));
        EXPECT_NEAR(c.x, space.white.x, 1e-3) << space.name;
        EXPECT_NEAR(c.y, space.white.y, 1e-3) << space.name;
    }
}

TEST(GridXyz, IsTheSumOfTheEquations) {
    const GridObserver seen_by = sampled_observer();
    Emission lamp;
    Reflectance material;
    lamp.value[20] = 1;
    lamp.value[40] = 0.5;
    material.value[20] = 0.25;
    material.value[40] = 0.75;
    const double k = seen_by.y[20] + 0.5 * seen_by.y[40];
    EXPECT_DOUBLE_EQ(grid_k(lamp, seen_by), k);
    const Xyz c = grid_xyz(lamp, material, seen_by);
    EXPECT_DOUBLE_EQ(c.x, (0.25 * seen_by.x[20] + 0.375 * seen_by.x[40]) / k);
    EXPECT_DOUBLE_EQ(c.y, (0.25 * seen_by.y[20] + 0.375 * seen_by.y[40]) / k);
    EXPECT_DOUBLE_EQ(c.z, (0.25 * seen_by.z[20] + 0.375 * seen_by.z[40]) / k);
}

} // namespace
} // namespace metamer
