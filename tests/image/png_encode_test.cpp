#include "image/png.h"

#include <cmath>

#include <gmock/gmock.h>

#include "color/working_space.h"
#include "image/error_of.h"
#include "image/png_bytes.h"

namespace metamer {
namespace {

using namespace std::string_literals;
using ::testing::Each;
using ::testing::HasSubstr;

// Every byte value occurs, in every channel.
Png gradient() {
    Png png;
    png.image = {64, 48, {}};
    for (unsigned i = 0; i < 64 * 48; ++i)
        for (const unsigned step : {1u, 3u, 7u, 11u})
            png.image.rgba.push_back(static_cast<std::uint8_t>(i * step + i / 64 * 5));
    return png;
}

std::string refused(const Png& png) {
    return error_of([&] { encode_png(png, true); });
}

TEST(EncodePng, KeepsEveryPixel) {
    const Png png = gradient();
    const Png back = decode_png(encode_png(png, true), "a.png", PngLayout::rgba8_only);
    EXPECT_EQ(back.image.width, 64);
    EXPECT_EQ(back.image.height, 48);
    EXPECT_EQ(back.image.rgba, png.image.rgba);
}

TEST(EncodePng, LeavesAlphaOut) {
    Png png = gradient();
    const std::string bytes = encode_png(png, false);
    EXPECT_THAT(error_of([&] { decode_png(bytes, "a.png", PngLayout::rgba8_only); }),
                HasSubstr("it has 8-bit RGB without alpha"));
    for (std::size_t i = 3; i < png.image.rgba.size(); i += 4)
        png.image.rgba[i] = 255;
    EXPECT_EQ(decode_png(bytes, "a.png").image.rgba, png.image.rgba);
}

TEST(EncodePng, KeepsText) {
    Png png = gradient();
    png.text = {{"Title", "Lumi\xC3\xA8re \xE5\x85\x89"}, {"Empty", ""}, {"Lines", "one\ttwo\nthree\n"}};
    EXPECT_EQ(decode_png(encode_png(png, true), "a.png").text, png.text);
}

TEST(EncodePng, GivesTheSameBytesForTheSameInput) {
    Png png = gradient();
    png.text = {{"b", "2"}, {"a", "1"}};
    png.color.srgb = true;
    const std::string bytes = encode_png(png, true);
    EXPECT_EQ(encode_png(png, true), bytes);
    EXPECT_EQ(encode_png(decode_png(bytes, "a.png"), true), bytes);
}

TEST(EncodePng, WritesOnlyTheChunksAskedFor) {
    Png png;
    png.image = {1, 1, {1, 2, 3, 4}};
    EXPECT_EQ(png_bytes::types_of(encode_png(png, true)), "IHDR IDAT IEND");
    png.text = {{"a", "1"}};
    png.color.gamma = 1 / 2.2;
    EXPECT_EQ(png_bytes::types_of(encode_png(png, true)), "IHDR gAMA iTXt IDAT IEND");
    png.text = {};
    png.color = {true, 0, {}};
    EXPECT_EQ(png_bytes::types_of(encode_png(png, true)), "IHDR gAMA sRGB cHRM IDAT IEND");
}

// The values that PNG 1.2 section 4.2.2.3 wants beside an sRGB chunk.
TEST(EncodePng, WritesTheGammaAndChromaticitiesOfSrgb) {
    Png png = gradient();
    png.color.srgb = true;
    std::map<std::string, std::string> data;
    for (const png_bytes::Chunk& c : png_bytes::chunks_of(encode_png(png, true)))
        data[c.type] = c.data;
    EXPECT_EQ(data["sRGB"], "\0"s);
    EXPECT_EQ(data["gAMA"], png_bytes::be32(45455));
    std::string xy;
    for (const std::uint32_t v : {31270u, 32900u, 64000u, 33000u, 30000u, 60000u, 15000u, 6000u})
        xy += png_bytes::be32(v);
    EXPECT_EQ(data["cHRM"], xy);
    const ColorChunks back = decode_png(encode_png(png, true), "a.png").color;
    EXPECT_TRUE(back.srgb);
    EXPECT_EQ(back.gamma, 0);
    EXPECT_FALSE(back.xy);
}

TEST(EncodePng, KeepsTheChromaticitiesOfEveryWorkingSpace) {
    for (const WorkingSpace& space : working_spaces()) {
        Png png = gradient();
        png.color.gamma = 1;
        png.color.xy = {space.white.x, space.white.y, space.red.x,  space.red.y,
                        space.green.x, space.green.y, space.blue.x, space.blue.y};
        const ColorChunks back = decode_png(encode_png(png, true), "a.png").color;
        EXPECT_FALSE(back.srgb);
        EXPECT_DOUBLE_EQ(back.gamma, 1);
        ASSERT_TRUE(back.xy) << space.name;
        for (std::size_t i = 0; i < 8; ++i)
            EXPECT_NEAR((*back.xy)[i], (*png.color.xy)[i], 0.5e-5 + 1e-12) << space.name << " " << i;
    }
}

TEST(EncodePng, RefusesSizesThatDoNotFit) {
    Png png;
    EXPECT_EQ(refused(png), "2: cannot encode a PNG: 0 x 0 pixels are outside 1 x 1 .. 4096 x 4096");
    png.image = {1, 4097, std::vector<std::uint8_t>(4 * 4097)};
    EXPECT_EQ(refused(png), "2: cannot encode a PNG: 1 x 4097 pixels are outside 1 x 1 .. 4096 x 4096");
    png.image = {2, 2, std::vector<std::uint8_t>(15)};
    EXPECT_EQ(refused(png), "2: cannot encode a PNG: 2 x 2 pixels take 16 bytes, not 15");
}

TEST(EncodePng, RefusesKeywordsAndTextsThatNoChunkHolds) {
    Png png = gradient();
    for (const std::string& key : {""s, " a"s, "a "s, "a  b"s, "caf\xC3\xA9"s, std::string(80, 'x')}) {
        png.text = {{key, "x"}};
        EXPECT_EQ(refused(png), "2: cannot encode a PNG: the keyword \"" + key +
                                    "\" is not 1 .. 79 printable ASCII characters with single blanks inside");
    }
    png.text = {{"a\tb", "x"}};
    EXPECT_EQ(refused(png),
              "2: cannot encode a PNG: the keyword \"a?b\" is not 1 .. 79 printable ASCII characters "
              "with single blanks inside");
    png.text = {{std::string(79, 'x'), "x"}};
    EXPECT_EQ(refused(png), "no error");
    for (const std::string& text : {"caf\xE9"s, "a\0b"s}) {
        png.text = {{"Title", text}};
        EXPECT_EQ(refused(png), "2: cannot encode a PNG: the text Title is not UTF-8 without NUL");
    }
    png.text = {{"Title", std::string(kMostTextBytes + 1, 'x')}};
    EXPECT_EQ(refused(png), "2: cannot encode a PNG: the text Title is over 1048576 bytes");
}

TEST(EncodePng, TakesTheLongestTextThatItReads) {
    Png png = gradient();
    png.text = {{std::string(79, 'k'), std::string(kMostTextBytes, 'x')}};
    EXPECT_EQ(decode_png(encode_png(png, true), "a.png").text, png.text);
}

TEST(EncodePng, RefusesColorsThatMakeNoSense) {
    Png png = gradient();
    for (const double gamma : {-1.0, 1e-6, 1e9}) {
        png.color.gamma = gamma;
        EXPECT_THAT(refused(png), HasSubstr("is outside 0.00001 .. 21474"));
    }
    png.color.gamma = std::nan("");
    EXPECT_EQ(refused(png), "2: cannot encode a PNG: the gamma nan is outside 0.00001 .. 21474");
    png.color.gamma = 0;
    png.color.xy = {0.3127, 0.329, 0.64, 0.33, 0.3, 0.6, 0.15, -0.06};
    EXPECT_EQ(refused(png), "2: cannot encode a PNG: the chromaticity coordinate -0.06 is outside 0 .. 1");
    png.color.xy = {0.3127, 0.329, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5}; // primaries on a point
    EXPECT_EQ(refused(png), "2: cannot encode a PNG: invalid chromaticities");
}

} // namespace
} // namespace metamer
