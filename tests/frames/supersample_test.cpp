#include "render/supersample.h"

#include <gtest/gtest.h>

#include "frames/frames.h"

namespace metamer {
namespace {

Image checker(std::uint8_t a, std::uint8_t b) {
    return {2, 2, {a, a, a, 255, b, b, b, 255, b, b, b, 255, a, a, a, 255}};
}

TEST(Averaged, IsTheMeanOfLightNotOfCodes) {
    // Half the light of white is code 188 (IEC 61966-2-1), not 128.
    EXPECT_EQ(averaged(checker(0, 255), 2, Transfer::srgb).rgba,
              (std::vector<std::uint8_t>{188, 188, 188, 255}));
    EXPECT_EQ(averaged(checker(0, 255), 2, Transfer::none).rgba,
              (std::vector<std::uint8_t>{128, 128, 128, 255}));
}

TEST(Supersampling, IsTheMeanOfALargerFrame) {
    Exhibit exhibit =
        exhibit_of("[display]\nwidth = 80\nheight = 45\n[scene]\nkind = loaf\nmaterials = crayons\n");
    exhibit.display.supersample = 2;
    const Image frame = frame_of(exhibit);
    exhibit.display.supersample = 1;
    exhibit.display.width_px *= 2;
    exhibit.display.height_px *= 2;
    EXPECT_EQ(frame.rgba, averaged(frame_of(exhibit), 2, Transfer::srgb).rgba);
}

TEST(Averaged, KeepsEveryFlatColor) {
    for (int code = 0; code < 256; ++code) {
        const auto c = static_cast<std::uint8_t>(code);
        EXPECT_EQ(averaged(checker(c, c), 2, Transfer::srgb).rgba, (std::vector<std::uint8_t>{c, c, c, 255}));
    }
}

TEST(Averaged, TakesEachPixelsOwnSquareAndChannel) {
    // Two squares of 2 x 2; codes are light here: the means are easy.
    const Image image{4, 2, {10, 0, 1, 255, 30, 0, 1, 255, 0, 200, 0, 255, 0, 100, 0, 255,
                             50, 0, 1, 255, 70, 0, 1, 255, 0, 40,  0, 255, 0, 20,  8, 255}};
    const Image small = averaged(image, 2, Transfer::none);
    EXPECT_EQ(small.width, 2);
    EXPECT_EQ(small.height, 1);
    EXPECT_EQ(small.rgba, (std::vector<std::uint8_t>{40, 0, 1, 255, 0, 90, 2, 255}));
}

TEST(Averaged, ByOneIsTheSame) {
    EXPECT_EQ(averaged(checker(3, 250), 1, Transfer::srgb).rgba, checker(3, 250).rgba);
}

} // namespace
} // namespace metamer
