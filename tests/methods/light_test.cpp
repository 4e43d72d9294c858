#include "methods/light.h"

#include <cmath>
#include <gtest/gtest.h>

namespace metamer {
namespace {

const SurfacePoint<double> kFloor{
    .position = {0, 0, 0}, .normal = {0, 1, 0}, .eye = {0, 5, 0}, .specular = 0, .shininess = 32};

LampPlace<double> lamp_at(double x, double y, double z) {
    return {.at = {x, y, z}, .directional = false, .falloff = {1, 0, 0}};
}

TEST(Light, FollowsTheCosine) {
    for (double degrees : {0.0, 30.0, 60.0, 89.0}) {
        const double a = degrees * 3.14159265358979 / 180;
        const LampPlace<double> lamp{
            .at = {std::sin(a), std::cos(a), 0}, .directional = true, .falloff = {1, 0, 0}};
        EXPECT_NEAR(arriving_light(lamp, kFloor).diffuse, std::cos(a), 1e-12) << degrees;
    }
}

TEST(Light, BelowTheSurfaceThereIsNone) {
    SurfacePoint<double> mirror = kFloor;
    mirror.specular = 1;
    mirror.shininess = 2;
    for (const auto& lamp :
         {lamp_at(0, -2, 0), lamp_at(5, -0.1, 0)}) { // the latter still faces the eye's half
        const Light<double> light = arriving_light(lamp, mirror);
        EXPECT_EQ(light.diffuse, 0);
        EXPECT_EQ(light.mirrored, 0);
    }
}

TEST(Light, FallsOffWithDistance) {
    LampPlace<double> lamp = lamp_at(0, 2, 0);
    lamp.falloff = {0.5, 0.25, 3};
    EXPECT_NEAR(arriving_light(lamp, kFloor).diffuse, 1 / (0.5 + 0.25 * 2 + 3 * 4), 1e-12);
    lamp.falloff = {0, 0, 1}; // the inverse square law
    const double near = arriving_light(lamp, kFloor).diffuse;
    lamp.at = {0, 4, 0};
    EXPECT_NEAR(near / arriving_light(lamp, kFloor).diffuse, 4, 1e-12);
}

TEST(Light, FromAfarDoesNotFallOff) {
    const LampPlace<double> sun{.at = {0, 1, 0}, .directional = true, .falloff = {2, 0.5, 3}};
    EXPECT_NEAR(arriving_light(sun, kFloor).diffuse, 1 / 2.0, 1e-12) << "only the constant counts";
}

TEST(Light, MirroredLightFallsOffToo) {
    SurfacePoint<double> mirror = kFloor;
    mirror.specular = 0.4;
    LampPlace<double> lamp = lamp_at(0, 2, 0);
    lamp.falloff = {0, 0, 1};
    EXPECT_NEAR(arriving_light(lamp, mirror).mirrored, 0.4 / 4, 1e-12);
    EXPECT_NEAR(arriving_light(lamp, mirror, 0.25).mirrored, 0.1 / 4, 1e-12) << "in half-shadow";
}

TEST(Light, AtTheLampItselfStaysFinite) {
    LampPlace<double> lamp = lamp_at(0, 1e-12, 0);
    lamp.falloff = {0, 0, 1};
    EXPECT_TRUE(std::isfinite(arriving_light(lamp, kFloor).diffuse));
    const LampPlace<Float16> narrow{
        .at = {}, .directional = false, .falloff = {Float16(0), Float16(0), Float16(1)}};
    const SurfacePoint<Float16> point{.position = {},
                                      .normal = {Float16(0), Float16(1), Float16(0)},
                                      .eye = {},
                                      .specular = Float16(1),
                                      .shininess = Float16(1000)};
    EXPECT_TRUE(std::isfinite(static_cast<float>(arriving_light(narrow, point).diffuse)));
    EXPECT_TRUE(std::isfinite(static_cast<float>(arriving_light(narrow, point).mirrored)));
}

// Lamp and eye mirrored about the normal: the half vector is the normal and the highlight at its full height.
TEST(Light, MirrorsWhereTheHalfVectorIsTheNormal) {
    SurfacePoint<double> mirror = kFloor;
    mirror.specular = 0.4;
    mirror.eye = {3, 4, 0};
    EXPECT_NEAR(arriving_light(lamp_at(-3, 4, 0), mirror).mirrored, 0.4, 1e-12);
    // 45 degrees from it, cos^32 is left.
    mirror.eye = {0, 4, 0};
    const double half_way = std::cos(std::atan2(3, 4) / 2);
    EXPECT_NEAR(arriving_light(lamp_at(-3, 4, 0), mirror).mirrored, 0.4 * std::pow(half_way, 32), 1e-12);
}

TEST(Light, ShadowTakesAll) {
    const Light<double> light = arriving_light(lamp_at(0, 1, 0), kFloor, 0.0);
    EXPECT_EQ(light.diffuse, 0);
}

// The form factor of a strip 0 .. 1 on one plane, without end along the edge, at a point of the other plane,
// d off the edge (Lambert): with the strip's height z, the integral of d z / (2 (d^2 + z^2)^(3/2)) dz.
TEST(BounceShare, IsTheIntegralOverTheWall) {
    for (const double d : {0.05, 0.25, 1.0, 3.0}) {
        double sum = 0;
        constexpr int kSteps = 100000;
        for (int i = 0; i < kSteps; ++i) {
            const double z = (i + 0.5) / kSteps;
            sum += d * z / (2 * std::pow(d * d + z * z, 1.5)) / kSteps;
        }
        EXPECT_NEAR(bounce_share(d), sum, 1e-6) << d;
        EXPECT_NEAR(static_cast<double>(bounce_share(static_cast<Float16>(d))), sum, 2e-3) << d;
    }
    EXPECT_EQ(bounce_share(0.0), 0.5);
}

} // namespace
} // namespace metamer
