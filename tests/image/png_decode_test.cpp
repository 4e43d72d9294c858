// decode_png against files put together by hand.
#include "image/png.h"

#include <gmock/gmock.h>

#include "image/error_of.h"
#include "image/png_bytes.h"

namespace metamer {
namespace {

using namespace std::string_literals;
using namespace png_bytes;
using ::testing::ElementsAre;
using ::testing::Pair;

const std::string kRow = "\0\x01\x02\x03\x04\x05\x06\x07\x08"s; // filter none, two RGBA pixels
std::string two_pixels(const std::string& before = {}) {
    return file(ihdr(2, 1, 8, rgba), kRow, before);
}

std::string refused(const std::string& bytes, PngLayout layout = PngLayout::any) {
    return error_of([&] { decode_png(bytes, "a.png", layout); });
}

TEST(DecodePng, ReadsRgba8AsItStands) {
    const Image image = decode_png(two_pixels(), "a.png", PngLayout::rgba8_only).image;
    EXPECT_EQ(image.width, 2);
    EXPECT_EQ(image.height, 1);
    EXPECT_THAT(image.rgba, ElementsAre(1, 2, 3, 4, 5, 6, 7, 8));
}

struct Layout {
    std::string bytes;
    std::vector<std::uint8_t> rgba;
    std::string name;
};

std::vector<Layout> layouts() {
    const std::string colors = chunk("PLTE", "\x0A\x14\x1E\x28\x32\x3C"s);
    return {
        {file(ihdr(2, 1, 1, palette), "\0\x40"s, colors), {10, 20, 30, 255, 40, 50, 60, 255}, "a palette"},
        {file(ihdr(2, 1, 8, palette), "\0\1\0"s, colors + chunk("tRNS", "\x64"s)),
         {40, 50, 60, 255, 10, 20, 30, 100},
         "a palette"},
        {file(ihdr(2, 1, 2, gray), "\0\x60"s), {85, 85, 85, 255, 170, 170, 170, 255}, "2-bit gray"},
        {file(ihdr(1, 1, 8, gray_alpha), "\0\x09\x08"s), {9, 9, 9, 8}, "8-bit gray with alpha"},
        {file(ihdr(1, 1, 8, rgb), "\0\1\2\3"s), {1, 2, 3, 255}, "8-bit RGB without alpha"},
        // 0x0100 / 65535 * 255 = 0.996: rounded to 1, where a cut to the upper byte happens to agree; 0x00FF:
        // 0.99 is 1, where the upper byte is 0.
        {file(ihdr(1, 1, 16, rgba), "\0\x01\x00\x00\xFF\xFF\xFF\x80\x80"s), {1, 1, 255, 128}, "16-bit RGBA"},
    };
}

TEST(DecodePng, ConvertsEveryLayoutWhereAnyWillDo) {
    for (const Layout& layout : layouts())
        EXPECT_EQ(decode_png(layout.bytes, "a.png").image.rgba, layout.rgba) << layout.name;
}

TEST(DecodePng, RefusesOtherLayoutsByName) {
    for (const Layout& layout : layouts())
        EXPECT_EQ(refused(layout.bytes, PngLayout::rgba8_only),
                  "2: cannot read a.png: it has " + layout.name + "; 8-bit RGBA is needed");
}

TEST(DecodePng, RefusesWhatIsNoPng) {
    EXPECT_EQ(refused(""), "2: cannot read a.png: it is empty");
    EXPECT_EQ(refused("wavelength_nm,E\n"), "2: cannot read a.png: it is not a PNG file");
    EXPECT_EQ(refused("G"), "2: cannot read a.png: it is not a PNG file");
}

TEST(DecodePng, RefusesTruncationAtEveryByte) {
    const std::string whole = two_pixels(chunk("tEXt", "Title\0a lamp"s));
    for (std::size_t n = 1; n < whole.size(); ++n)
        EXPECT_EQ(refused(whole.substr(0, n)), "2: cannot read a.png: it is cut short") << n;
    EXPECT_EQ(refused(whole), "no error");
}

TEST(DecodePng, RefusesChunksThatAreMissingOrDamaged) {
    EXPECT_EQ(refused(kSignature + ihdr(2, 1, 8, rgba) + chunk("IEND", {})),
              "2: cannot read a.png: it is damaged (IEND: out of place)");
    EXPECT_EQ(refused(kSignature + chunk("IEND", {})),
              "2: cannot read a.png: it is damaged (IEND: out of place)");
    EXPECT_EQ(refused(file(ihdr(2, 2, 8, rgba), kRow)),
              "2: cannot read a.png: it is damaged (Not enough image data)");
    EXPECT_EQ(refused(file(ihdr(2, 1, 8, rgba), kRow + kRow)),
              "2: cannot read a.png: it is damaged (IDAT: Too much image data)");
    EXPECT_EQ(refused(file(ihdr(0, 1, 8, rgba), kRow)),
              "2: cannot read a.png: it is damaged (Invalid IHDR data)");
}

TEST(DecodePng, RefusesEveryChecksumThatFails) {
    const std::string whole = two_pixels(chunk("tEXt", "Title\0a lamp"s));
    std::size_t end = kSignature.size();
    for (const Chunk& c : chunks_of(whole)) {
        end += 12 + c.data.size();
        std::string damaged = whole;
        damaged[end - 1] = static_cast<char>(damaged[end - 1] ^ 1);
        EXPECT_EQ(refused(damaged), "2: cannot read a.png: it is damaged (" + c.type + ": CRC error)");
    }
}

TEST(DecodePng, RefusesPixelsWhoseAdlerSumFails) {
    std::string data = zlib_stored(kRow);
    data.back() = static_cast<char>(data.back() ^ 1);
    EXPECT_EQ(refused(kSignature + ihdr(2, 1, 8, rgba) + chunk("IDAT", data) + chunk("IEND", {})),
              "2: cannot read a.png: it is damaged (IDAT: incorrect data check)");
}

TEST(DecodePng, IgnoresWhatFollowsTheEnd) {
    EXPECT_EQ(refused(two_pixels() + "trailing"), "no error");
}

TEST(DecodePng, RefusesSidesOver4096BeforeItReadsPixels) {
    EXPECT_EQ(refused(file(ihdr(4097, 1, 8, rgba), kRow)),
              "2: cannot read a.png: it has 4097 x 1 pixels; at most 4096 x 4096 are read");
    EXPECT_EQ(refused(file(ihdr(1, 0x7FFFFFFF, 8, rgba), kRow)),
              "2: cannot read a.png: it has 1 x 2147483647 pixels; at most 4096 x 4096 are read");
    EXPECT_EQ(refused(file(ihdr(4096, 1, 8, gray), std::string(4097, '\0'))), "no error");
}

TEST(DecodePng, ReadsEveryKindOfText) {
    const Png png =
        decode_png(two_pixels(chunk("tEXt", "Latin\0caf\xE9"s) +
                              chunk("zTXt", "Packed\0\0"s + zlib_stored("lumi\xE8re")) +
                              chunk("iTXt", "International\0\0\0en\0\0\xE5\x85\x89"s) +
                              chunk("iTXt", "Packed too\0\1\0\0\0"s + zlib_stored("\xE5\x85\x89"))),
                   "a.png");
    EXPECT_THAT(png.text, ElementsAre(Pair("International", "\xE5\x85\x89"), Pair("Latin", "caf\xC3\xA9"),
                                      Pair("Packed", "lumi\xC3\xA8re"), Pair("Packed too", "\xE5\x85\x89")));
}

TEST(DecodePng, ReadsTextBehindThePixels) {
    const std::string bytes = kSignature + ihdr(2, 1, 8, rgba) + chunk("IDAT", zlib_stored(kRow)) +
                              chunk("tEXt", "Comment\0late"s) + chunk("IEND", {});
    EXPECT_THAT(decode_png(bytes, "a.png").text, ElementsAre(Pair("Comment", "late")));
}

TEST(DecodePng, JoinsTextsOfOneKeyword) {
    const std::string bytes = two_pixels(chunk("tEXt", "Comment\0one"s) + chunk("tEXt", "Comment\0two"s));
    EXPECT_THAT(decode_png(bytes, "a.png").text, ElementsAre(Pair("Comment", "one\ntwo")));
}

TEST(DecodePng, RefusesTextThatIsNotUtf8) {
    EXPECT_EQ(refused(two_pixels(chunk("iTXt", "Comment\0\0\0\0\0caf\xE9"s))),
              "2: cannot read a.png: its text Comment is not UTF-8");
}

TEST(DecodePng, BoundsTexts) {
    std::string many;
    for (int i = 0; i < 64; ++i)
        many += chunk("tEXt", "Comment\0x"s);
    EXPECT_EQ(refused(two_pixels(many)), "no error");
    EXPECT_EQ(refused(two_pixels(many + chunk("tEXt", "Comment\0x"s))),
              "2: cannot read a.png: it is damaged (tEXt: no space in chunk cache)");
    EXPECT_EQ(refused(two_pixels(chunk("tEXt", "Comment\0"s + std::string(kMostTextBytes, 'x')))),
              "no error");
    EXPECT_EQ(refused(two_pixels(chunk("tEXt", "Comment\0"s + std::string(kMostTextBytes + 2000, 'x')))),
              "2: cannot read a.png: it is damaged (tEXt: chunk data is too large)");
}

// The pixels of a black picture, passed off as text: a few kilobytes that unpack to 4 * 512 * rows.
std::string packed_text(int rows) {
    Png black;
    black.image = {512, rows, std::vector<std::uint8_t>(4u * 512 * static_cast<unsigned>(rows))};
    std::string packed;
    for (const Chunk& c : chunks_of(encode_png(black, true)))
        packed += c.type == "IDAT" ? c.data : "";
    return chunk("zTXt", "Comment\0\0"s + packed);
}

TEST(DecodePng, BoundsTextThatUnpacks) {
    EXPECT_LT(packed_text(1024).size(), 10000u);
    EXPECT_EQ(refused(two_pixels(packed_text(500))), "no error");
    EXPECT_EQ(refused(two_pixels(packed_text(1024))),
              "2: cannot read a.png: it is damaged (zTXt: truncated)");
}

TEST(DecodePng, ReadsColorChunks) {
    const Png plain = decode_png(two_pixels(), "a.png");
    EXPECT_FALSE(plain.color.srgb);
    EXPECT_EQ(plain.color.gamma, 0);
    EXPECT_FALSE(plain.color.xy);

    EXPECT_TRUE(decode_png(two_pixels(chunk("sRGB", "\0"s)), "a.png").color.srgb);

    const std::string ntsc = be32(31006) + be32(31616) + be32(67000) + be32(33000) + be32(21000) +
                             be32(71000) + be32(14000) + be32(8000);
    const Png png = decode_png(two_pixels(chunk("gAMA", be32(100000)) + chunk("cHRM", ntsc)), "a.png");
    EXPECT_FALSE(png.color.srgb);
    EXPECT_DOUBLE_EQ(png.color.gamma, 1);
    ASSERT_TRUE(png.color.xy);
    const double expected[] = {0.31006, 0.31616, 0.67, 0.33, 0.21, 0.71, 0.14, 0.08};
    for (std::size_t i = 0; i < 8; ++i)
        EXPECT_NEAR((*png.color.xy)[i], expected[i], 1e-12) << i;
}

TEST(DecodePng, PassesOverChunksOfNoUse) {
    EXPECT_EQ(
        refused(two_pixels(chunk("iCCP", "broken"s) + chunk("tIME", "x"s) + chunk("prVt", "anything"s))),
        "no error");
    EXPECT_EQ(refused(two_pixels(chunk("CRIT", "x"s))),
              "2: cannot read a.png: it is damaged (CRIT: unhandled critical chunk)");
}

} // namespace
} // namespace metamer
