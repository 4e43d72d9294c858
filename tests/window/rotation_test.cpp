#include "window/rotation.h"

#include <gtest/gtest.h>

namespace metamer {
namespace {

constexpr PxSize kSurface{800, 480};

class Rotation : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Of, Rotation, testing::Values(0, 90, 180, 270));

void expect_point(PxPoint point, double x_px, double y_px) {
    EXPECT_EQ(point.x_px, x_px);
    EXPECT_EQ(point.y_px, y_px);
}

/// Where the picture's upper left corner comes to lie, and where its upper right one: clockwise from corner
/// to corner.
TEST(RotationCorners, GoClockwise) {
    expect_point(surface_from_picture({0, 0}, kSurface, 0), 0, 0);
    expect_point(surface_from_picture({800, 0}, kSurface, 0), 800, 0);
    expect_point(surface_from_picture({0, 0}, kSurface, 90), 800, 0);
    expect_point(surface_from_picture({480, 0}, kSurface, 90), 800, 480);
    expect_point(surface_from_picture({0, 0}, kSurface, 180), 800, 480);
    expect_point(surface_from_picture({800, 0}, kSurface, 180), 0, 480);
    expect_point(surface_from_picture({0, 0}, kSurface, 270), 0, 480);
    expect_point(surface_from_picture({480, 0}, kSurface, 270), 0, 0);
}

TEST(RotationSize, IsExchangedOnItsSide) {
    EXPECT_EQ(turned(kSurface, 0), (PxSize{800, 480}));
    EXPECT_EQ(turned(kSurface, 90), (PxSize{480, 800}));
    EXPECT_EQ(turned(kSurface, 180), (PxSize{800, 480}));
    EXPECT_EQ(turned(kSurface, 270), (PxSize{480, 800}));
}

TEST_P(Rotation, ThereAndBackIsTheSamePoint) {
    for (const PxPoint point : {PxPoint{0, 0}, PxPoint{13.5, 470.25}, PxPoint{799.5, 0.5}}) {
        const PxPoint picture = picture_from_surface(point, kSurface, GetParam());
        expect_point(surface_from_picture(picture, kSurface, GetParam()), point.x_px, point.y_px);
    }
}

TEST_P(Rotation, ASurfacesPointsAreThePicturesOwn) {
    const PxSize picture = turned(kSurface, GetParam());
    for (const PxPoint corner : {PxPoint{0, 0}, PxPoint{800, 0}, PxPoint{800, 480}, PxPoint{0, 480}}) {
        const PxPoint point = picture_from_surface(corner, kSurface, GetParam());
        EXPECT_TRUE(point.x_px == 0 || point.x_px == picture.width_px) << point.x_px;
        EXPECT_TRUE(point.y_px == 0 || point.y_px == picture.height_px) << point.y_px;
    }
}

/// The matrix says of clip coordinates what the functions say of pixels.
TEST_P(Rotation, TheMatrixAgreesWithThePoints) {
    const auto matrix = surface_clip_from_picture_clip(GetParam());
    const PxSize picture = turned(kSurface, GetParam());
    const PxPoint point{picture.width_px * 0.25, picture.height_px * 0.375};
    const double x = -0.5, y = 0.25; // the same point in clip coordinates
    const double clip_x = static_cast<double>(matrix[0]) * x + static_cast<double>(matrix[2]) * y;
    const double clip_y = static_cast<double>(matrix[1]) * x + static_cast<double>(matrix[3]) * y;
    expect_point(surface_from_picture(point, kSurface, GetParam()), (clip_x + 1) / 2 * kSurface.width_px,
                 (1 - clip_y) / 2 * kSurface.height_px);
}

} // namespace
} // namespace metamer
