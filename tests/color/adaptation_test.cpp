#include "color/adaptation.h"

#include <gmock/gmock.h>

#include "base/error.h"
#include "color/colorimetry.h"

namespace metamer {
namespace {

using testing::HasSubstr;

std::array<double, 3> array_of(const Xyz& c) {
    return {c.x, c.y, c.z};
}

const Xyz kA{1.09850, 1, 0.35585}, kD65{0.95047, 1, 1.08883}, kD50{0.96422, 1, 0.82521};

TEST(Bradford, TakesOneWhiteToTheOther) {
    const auto adapted = bradford(kA, kD65) * array_of(kA);
    EXPECT_NEAR(adapted[0], kD65.x, 1e-6);
    EXPECT_NEAR(adapted[1], kD65.y, 1e-6);
    EXPECT_NEAR(adapted[2], kD65.z, 1e-6);
}

// The matrix that ICC.1:2022 and Lindbloom print for D65 to D50.
TEST(Bradford, IsThePublishedMatrixFromD65ToD50) {
    constexpr double published[3][3] = {{1.0478112, 0.0228866, -0.0501270},
                                        {0.0295424, 0.9904844, -0.0170491},
                                        {-0.0092345, 0.0150436, 0.7521316}};
    const Matrix3 m = bradford(kD65, kD50);
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            EXPECT_NEAR(m.m[i][j], published[i][j], 1e-5) << i << ' ' << j;
}

TEST(Bradford, ThereAndBackIsIdentity) {
    const Matrix3 m = bradford(kD50, kA) * bradford(kA, kD50);
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            EXPECT_NEAR(m.m[i][j], i == j ? 1 : 0, 1e-6);
}

TEST(Bradford, RefusesALampWithoutBlue) {
    try {
        bradford(xyz_of({0.5693, 0.4302}), kD65); // low-pressure sodium: Z is next to nothing
        FAIL() << "accepted";
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), Exit::bad_input);
        EXPECT_THAT(error.what(), HasSubstr("cannot adapt to the lamp: its light does not excite"));
    }
}

} // namespace
} // namespace metamer
