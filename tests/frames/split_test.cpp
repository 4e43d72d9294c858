// The split: where it lies, what stands left and right of it, and that under equal energy nothing tells the
// halves apart.
#include <gtest/gtest.h>

#include "frames/frames.h"
#include "render/scene.h"

namespace metamer {
namespace {

std::string crayons(const std::string& lamp, const std::string& compare) {
    return "[display]\nwidth = 160\nheight = 90\n[scene]\nkind = crayons\nmaterials = "
           "crayons\n[lamp.1]\nspectrum = " +
           lamp + "\n" + compare;
}

const char* const kLeft = "[accuracy]\nmethod = tristimulus\n";
const char* const kRight = "[accuracy]\nmethod = spectral\n";

std::string split_at(const std::string& where, int line = 0) {
    return "[compare]\nsplit = " + where + "\nline = " + std::to_string(line) +
           "\nleft.method = tristimulus\nright.method = spectral\n";
}

TEST(Split, IsAtTheExactColumn) {
    const Image left = frame_of(exhibit_of(crayons("A2800", kLeft)));
    const Image right = frame_of(exhibit_of(crayons("A2800", kRight)));
    ASSERT_NE(left.rgba, right.rgba);
    for (int column : {0, 1, 37, 80, 159, 160}) {
        const Image both = frame_of(exhibit_of(crayons("A2800", split_at(std::to_string(column) + "px"))));
        for (int y = 0; y < 90; ++y)
            for (int x = 0; x < 160; ++x)
                ASSERT_EQ(pixel(both, x, y), pixel(x < column ? left : right, x, y))
                    << column << ": " << x << ' ' << y;
    }
}

TEST(Split, MayBeAShareOfTheWidth) {
    Compare compare;
    compare.split = 0.25;
    EXPECT_EQ(split_column(compare, 160), 40);
    compare.split = 0.33;
    EXPECT_EQ(split_column(compare, 160), 53) << "52.8, rounded";
    compare.split = 1;
    EXPECT_EQ(split_column(compare, 160), 160);
    compare.split_px = 4000; // a narrower frame than the INI's author had
    EXPECT_EQ(split_column(compare, 160), 160);
}

TEST(Split, LineLiesOverItsColumn) {
    const Image plain = frame_of(exhibit_of(crayons("A2800", split_at("80px"))));
    const Image lined = frame_of(exhibit_of(crayons("A2800", split_at("80px", 2))));
    for (int x = 0; x < 160; ++x)
        for (int y = 0; y < 90; ++y)
            if (x == 79 || x == 80)
                ASSERT_EQ(pixel(lined, x, y), (EncodedRgb8{140, 140, 140})) << x;
            else
                ASSERT_EQ(pixel(lined, x, y), pixel(plain, x, y)) << x;
}

TEST(Split, UnderEqualEnergyTheHalvesAreOnePicture) {
    const Image left = frame_of(exhibit_of(crayons("E", kLeft))),
                right = frame_of(exhibit_of(crayons("E", kRight)));
    for (int y = 0; y < 90; ++y)
        for (int x = 0; x < 160; ++x)
            ASSERT_LE(steps(pixel(left, x, y), pixel(right, x, y)), 1) << x << ' ' << y;
}

TEST(Split, HalvesMayDifferInLampStrengthAndSpace) {
    const std::string halves =
        "[compare]\nsplit = 80px\nline = 0\nleft.lamp = A2800\nleft.strength = 2\nright.lamp = F11\n"
        "right.working_space = Adobe-D65\n";
    const Image both = frame_of(exhibit_of(crayons("E", halves)));
    const Image left = frame_of(exhibit_of(crayons("A2800\nstrength = 2", "")));
    Exhibit adobe = exhibit_of(crayons("F11", ""));
    adobe.display.working_space = find_working_space("Adobe-D65");
    const Image right = frame_of(adobe);
    for (int y = 0; y < 90; ++y) {
        ASSERT_EQ(pixel(both, 79, y), pixel(left, 79, y)) << y;
        ASSERT_EQ(pixel(both, 80, y), pixel(right, 80, y)) << y;
    }
}

Image supersampled(const std::string& rest) {
    Exhibit exhibit = exhibit_of(crayons("A2800", rest));
    exhibit.display.supersample = 2;
    return frame_of(exhibit);
}

TEST(Split, ScalesWithSupersampling) {
    const Image both = supersampled(split_at("37px")), left = supersampled(kLeft),
                right = supersampled(kRight);
    for (int y = 0; y < 90; ++y) {
        ASSERT_EQ(pixel(both, 36, y), pixel(left, 36, y)) << y;
        ASSERT_EQ(pixel(both, 37, y), pixel(right, 37, y)) << y;
    }
}

TEST(Split, LineScalesWithSupersampling) {
    const Image plain = supersampled(split_at("80px")), lined = supersampled(split_at("80px", 2));
    for (int y = 0; y < 90; ++y)
        for (int x = 77; x < 83; ++x)
            if (x == 79 || x == 80)
                ASSERT_EQ(pixel(lined, x, y), (EncodedRgb8{140, 140, 140})) << x;
            else
                ASSERT_EQ(pixel(lined, x, y), pixel(plain, x, y)) << x;
}

} // namespace
} // namespace metamer
