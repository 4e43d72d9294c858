#include "atlas/atlas_picture.h"

#include <gmock/gmock.h>

#include "atlas/samples.h"

namespace metamer {
namespace {

using ::testing::ElementsAre;

// Left edges of an interval's bar in the lamps' and in the materials' half, and the top of a strip.
int lamp_x(int interval) {
    return 8 + 7 * interval;
}
int material_x(int interval) {
    return 8 + 448 + 16 + 7 * interval;
}
int strip_y(int row) {
    return 8 + 14 * row;
}

std::vector<int> pixel(const Image& image, int x, int y) {
    const auto at = static_cast<std::size_t>((y * image.width + x) * 4);
    return {image.rgba[at], image.rgba[at + 1], image.rgba[at + 2], image.rgba[at + 3]};
}

TEST(AtlasPicture, IsAsHighAsTheRowsInUse) {
    const Image image = picture(sample_atlas());
    EXPECT_EQ(image.width, 928);
    EXPECT_EQ(image.height, 16 + 3 * 14 + 12);
    EXPECT_EQ(image.rgba.size(), static_cast<std::size_t>(928 * 70 * 4));
    EXPECT_EQ(picture(empty_atlas()).height, 28);
}

TEST(AtlasPicture, IsOpaque) {
    const Image image = picture(sample_atlas());
    for (std::size_t i = 3; i < image.rgba.size(); i += 4)
        ASSERT_EQ(image.rgba[i], 255);
}

TEST(AtlasPicture, BarsAreAsHighAsTheirValues) {
    const Image image = picture(sample_atlas());
    const auto background = ElementsAre(44, 44, 44, 255);
    // Half a reflectance: the lower six of twelve pixels.
    EXPECT_THAT(pixel(image, material_x(30), strip_y(1) + 5), background);
    EXPECT_THAT(pixel(image, material_x(30), strip_y(1) + 6), ::testing::Not(background));
    // Black: none. The ramp's end: all twelve.
    EXPECT_THAT(pixel(image, material_x(30), strip_y(2) + 11), background);
    EXPECT_THAT(pixel(image, lamp_x(63) + 6, strip_y(1)), ::testing::Not(background));
    EXPECT_THAT(pixel(image, lamp_x(0), strip_y(1) + 11), background);
    // No material in row 3: not even a strip.
    EXPECT_THAT(pixel(image, material_x(30), strip_y(3) + 11), ElementsAre(20, 20, 20, 255));
}

// Spectral colors clipped to sRGB: 700 nm has red only, 450 nm and 530 nm are greatest in blue and in green.
TEST(AtlasPicture, BarsHaveTheirWavelengthsColor) {
    const Image image = picture(sample_atlas());
    EXPECT_THAT(pixel(image, lamp_x(63), strip_y(1)), ElementsAre(255, 0, 0, 255));
    const auto blue = pixel(image, material_x(13), strip_y(1) + 11);
    EXPECT_EQ(blue[2], 255);
    EXPECT_LT(blue[0], 128);
    EXPECT_EQ(blue[1], 0);
    EXPECT_THAT(pixel(image, material_x(29), strip_y(1) + 11), ElementsAre(0, 255, 0, 255));
    // 400 nm: dim to the eye, and as bright as all the others here.
    EXPECT_EQ(pixel(image, material_x(3), strip_y(1) + 11)[2], 255);
    // The same in the legend above.
    EXPECT_EQ(pixel(image, material_x(13), strip_y(0)), blue);
}

TEST(AtlasPicture, DrawsTheObserverAsThreeOverlappingBars) {
    const Image image = picture(sample_atlas());
    // 445 nm: z is full height; x = 50 / 255 takes the lowest two pixels, y = 4 / 255 none.
    EXPECT_THAT(pixel(image, lamp_x(12), strip_y(0)), ElementsAre(44, 44, 255, 255));
    EXPECT_THAT(pixel(image, lamp_x(12), strip_y(0) + 9), ElementsAre(44, 44, 255, 255));
    EXPECT_THAT(pixel(image, lamp_x(12), strip_y(0) + 10), ElementsAre(255, 44, 255, 255));
}

} // namespace
} // namespace metamer
