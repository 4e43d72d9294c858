#include "color/colorimetry.h"

#include <gmock/gmock.h>

#include "base/error.h"
#include "color/observer.h"
#include "color/resample.h"

namespace metamer {
namespace {

const LampSpectrum kEqualEnergy{{{360, 830}, {1, 1}}, {}};
const MaterialSpectrum kPerfect{{{360, 830}, {1, 1}}};

TEST(Reference, PerfectReflectorHasYOfOne) {
    EXPECT_DOUBLE_EQ(reference_xyz(kEqualEnergy, kPerfect).y, 1);
}

// The table's sums of x, y, z (106.865, 106.857, 106.892) are equal to 4e-4 only.
TEST(Reference, EqualEnergyLiesAtOneThird) {
    const Chromaticity c = chromaticity(reference_white(kEqualEnergy));
    EXPECT_NEAR(c.x, 1.0 / 3, 5e-5);
    EXPECT_NEAR(c.y, 1.0 / 3, 5e-5);
}

TEST(Reference, IsLinearInReflectance) {
    const MaterialSpectrum slope{{{360, 830}, {0, 1}}}, back{{{360, 830}, {1, 0}}};
    const Xyz a = reference_xyz(kEqualEnergy, slope), b = reference_xyz(kEqualEnergy, back);
    const Xyz whole = reference_white(kEqualEnergy);
    EXPECT_NEAR(a.x + b.x, whole.x, 1e-12);
    EXPECT_NEAR(a.y + b.y, whole.y, 1e-12);
    EXPECT_NEAR(a.z + b.z, whole.z, 1e-12);
}

// A line's XYZ is the observer at its wavelength over y there, whatever its power.
TEST(Reference, ALineHasTheObserversColor) {
    const auto& row = cie_1931_2deg()[589 - 360];
    const Xyz c = reference_white({{}, {{589, 17}}});
    EXPECT_NEAR(c.x, row.x / row.y, 1e-12);
    EXPECT_NEAR(c.z, row.z / row.y, 1e-12);
}

TEST(Reference, RefusesALampThatNobodySees) {
    EXPECT_THROW(reference_white({{}, {{200, 1}}}), Error);
    EXPECT_THROW(reference_white({{{400, 500}, {0, 0}}, {}}), Error);
}

TEST(Chromaticity, ThereAndBack) {
    const Chromaticity c = chromaticity(xyz_of({0.3127, 0.3290}));
    EXPECT_NEAR(c.x, 0.3127, 1e-12);
    EXPECT_NEAR(c.y, 0.3290, 1e-12);
    EXPECT_EQ(chromaticity({0, 0, 0}).x, 0);
}

} // namespace
} // namespace metamer
