#include "render/frame.h"

#include <gtest/gtest.h>

namespace metamer {
namespace {

TEST(ColorChunks, SayWhatThePixelsMean) {
    Display display;
    EXPECT_TRUE(color_chunks(display).srgb);
    display.working_space = find_working_space("PAL-D65");
    EXPECT_FALSE(color_chunks(display).srgb);
    EXPECT_DOUBLE_EQ(color_chunks(display).gamma, 1 / 2.2);
    display.working_space = &working_spaces()[0];
    display.matrix = rgb_from_xyz(*find_working_space("Adobe-D65"));
    EXPECT_FALSE(color_chunks(display).srgb);
    EXPECT_NEAR(color_chunks(display).xy.value()[4], 0.21, 1e-9); // green's x
    display.matrix.reset();
    display.transfer = Transfer::none;
    EXPECT_FALSE(color_chunks(display).srgb);
    EXPECT_EQ(color_chunks(display).gamma, 1);
    display.working_space = find_working_space("NTSC-C");
    const auto xy = color_chunks(display).xy.value();
    EXPECT_NEAR(xy[0], 0.31006, 1e-9);    // white
    EXPECT_NEAR(xy[5], 0.71, 1e-9);       // green's y
    display.matrix = Matrix3::identity(); // primaries X, Y, Z: y of X is 0, no chromaticities for a PNG
    EXPECT_FALSE(color_chunks(display).xy);
}

TEST(EncodedFrame, NamesItsExhibit) {
    Exhibit exhibit;
    exhibit.place = "config/some.ini";
    const Png png = decode_png(encode_frame({1, 1, {1, 2, 3, 255}}, exhibit), "frame");
    EXPECT_EQ(png.text.at("Title"), "config/some.ini");
    EXPECT_TRUE(png.color.srgb);
}

} // namespace
} // namespace metamer
