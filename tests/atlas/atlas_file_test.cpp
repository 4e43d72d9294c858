#include "atlas/atlas_file.h"

#include <filesystem>
#include <functional>
#include <limits>

#include <gmock/gmock.h>
#include <unistd.h>

#include "atlas/atlas_text.h"
#include "atlas/samples.h"
#include "base/files.h"
#include "base/numbers.h"
#include "image/error_of.h"
#include "image/png.h"
#include "image/png_bytes.h"

namespace metamer {
namespace {

using namespace std::string_literals;
using ::testing::ElementsAre;
using ::testing::Pair;

std::string refused(const std::string& bytes) {
    return error_of([&] { decode_atlas(bytes, "a.png"); });
}

// The sample's PNG after a change to its pixels or texts.
std::string changed(const std::function<void(Png&)>& change) {
    Png png = decode_png(encode_atlas(sample_atlas()), "a.png");
    change(png);
    return encode_png(png, true);
}

std::string with_text(const std::string& key, const std::string& text) {
    return changed([&](Png& png) { png.text["metamer:" + key] = text; });
}

std::string with_byte(int row, std::size_t interval, AtlasChannel channel, int value) {
    return changed([&](Png& png) {
        png.image.rgba[atlas_byte(row, interval, channel)] = static_cast<std::uint8_t>(value);
    });
}

TEST(AtlasFile, KeepsEverything) {
    Atlas atlas = sample_atlas(Quantization::weighted);
    atlas.materials[2].scale = 0.05;
    const Atlas back = decode_atlas(encode_atlas(atlas), "a.png");
    EXPECT_EQ(back.rgba, atlas.rgba);
    EXPECT_EQ(back.quantization, Quantization::weighted);
    for (std::size_t row = 0; row < kAtlasSize; ++row) {
        EXPECT_EQ(back.lamps[row].name, atlas.lamps[row].name);
        EXPECT_EQ(back.lamps[row].source, atlas.lamps[row].source);
        EXPECT_EQ(back.lamps[row].peak, atlas.lamps[row].peak);
        EXPECT_EQ(back.materials[row].name, atlas.materials[row].name);
        EXPECT_EQ(back.materials[row].source, atlas.materials[row].source);
        EXPECT_EQ(back.materials[row].scale, atlas.materials[row].scale);
    }
}

TEST(AtlasFile, HoldsAllLampsWithAnySetOfMaterials) {
    for (const MaterialSet& set : material_sets()) {
        Atlas atlas = empty_atlas();
        for (const Lamp& lamp : library_lamps())
            add_lamp(atlas, lamp);
        for (const std::string& name : set.materials)
            add_material(atlas, find_material(name));
        const Atlas back = decode_atlas(encode_atlas(atlas), "a.png");
        EXPECT_EQ(back.rgba, atlas.rgba) << set.name;
        for (const Lamp& lamp : library_lamps())
            EXPECT_EQ(back.lamps[static_cast<std::size_t>(find_lamp_key(back, lamp.name))].name, lamp.name);
        EXPECT_EQ(find_material_key(back, set.materials.back()), static_cast<int>(set.materials.size()))
            << set.name;
    }
}

TEST(AtlasFile, IsReproducible) {
    const std::string bytes = encode_atlas(sample_atlas());
    EXPECT_EQ(encode_atlas(sample_atlas()), bytes);
    EXPECT_EQ(encode_atlas(decode_atlas(bytes, "a.png")), bytes);
}

TEST(AtlasFile, IsA64x64Rgba8PngWithReadableTexts) {
    const std::string bytes = encode_atlas(sample_atlas());
    const auto chunks = png_bytes::chunks_of(bytes);
    EXPECT_EQ(chunks.front().data, "\0\0\0\x40\0\0\0\x40\x08\x06\0\0\0"s);
    EXPECT_THAT(decode_png(bytes, "a.png").text,
                ElementsAre(Pair("metamer:atlas", "1"),
                            Pair("metamer:lamps", "1\tramp\t12.3\ta test\n"
                                                  "2\tline:589.3\t" +
                                                      to_text(sample_atlas().lamps[2].peak) +
                                                      "\ta formula\n"
                                                      "3\tGl\xC3\xBChlampe\t0.1\t\xE5\x85\x89, 2015\n"),
                            Pair("metamer:materials", "1\tgray\t1\ta test\n2\tblack\t1\ta test\n"),
                            Pair("metamer:observer", "CIE 1931 2 degree")));
}

TEST(AtlasFile, TakesAnAtlasOfTheObserverOnly) {
    for (const QuantizationName& known : kQuantizations) {
        const Atlas back = decode_atlas(encode_atlas(empty_atlas(known.quantization)), "a.png");
        EXPECT_EQ(back.rgba, empty_atlas(known.quantization).rgba);
        EXPECT_EQ(back.quantization, known.quantization);
    }
}

// An atlas that does not say is the thesis's, as all were; what it says must be so.
TEST(AtlasFile, TheQuantizationTravelsAndRow0Agrees) {
    Png png = decode_png(encode_atlas(sample_atlas(Quantization::weighted)), "a.png");
    EXPECT_EQ(png.text.at("metamer:quantization"), "weighted");
    EXPECT_FALSE(decode_png(encode_atlas(sample_atlas()), "a.png").text.contains("metamer:quantization"));
    png.text.erase("metamer:quantization");
    EXPECT_EQ(refused(encode_png(png, true)),
              "2: cannot read a.png: row 0 is not the CIE 1931 observer of quantization thesis");
    EXPECT_EQ(refused(with_text("quantization", "weighted")),
              "2: cannot read a.png: row 0 is not the CIE 1931 observer of quantization weighted");
    EXPECT_EQ(
        refused(with_text("quantization", "finest")),
        "2: cannot read a.png: metamer:quantization is \"finest\"; only \"thesis\" and \"weighted\" are "
        "known");
    EXPECT_EQ(refused(with_text("quantization", "thesis")), "no error");
}

TEST(AtlasFile, RefusesTruncationAtEveryByte) {
    const std::string whole = encode_atlas(sample_atlas());
    EXPECT_EQ(refused(""), "2: cannot read a.png: it is empty");
    for (std::size_t n = 1; n < whole.size(); ++n)
        ASSERT_EQ(refused(whole.substr(0, n)), "2: cannot read a.png: it is cut short") << n;
}

// A CRC-32 finds every burst of up to 32 bits, so no single byte may pass.
TEST(AtlasFile, RefusesCorruptionOfEveryByte) {
    const std::string whole = encode_atlas(sample_atlas());
    for (std::size_t n = 0; n < whole.size(); ++n)
        for (const int bits : {0x01, 0x20, 0xFF}) {
            std::string damaged = whole;
            damaged[n] = static_cast<char>(damaged[n] ^ bits);
            ASSERT_THAT(refused(damaged), ::testing::StartsWith("2: cannot read a.png: it is "))
                << n << " " << bits;
        }
}

TEST(AtlasFile, RefusesOtherLayoutsByName) {
    using namespace png_bytes;
    const auto rows = [](std::size_t bytes) {
        std::string out;
        for (int y = 0; y < 64; ++y)
            out += std::string(1 + bytes, '\0');
        return out;
    };
    EXPECT_EQ(refused(file(ihdr(64, 64, 8, palette), rows(64), chunk("PLTE", "abc"))),
              "2: cannot read a.png: it has a palette; 8-bit RGBA is needed");
    EXPECT_EQ(refused(file(ihdr(64, 64, 16, rgba), rows(512))),
              "2: cannot read a.png: it has 16-bit RGBA; 8-bit RGBA is needed");
    EXPECT_EQ(refused(file(ihdr(64, 64, 8, gray), rows(64))),
              "2: cannot read a.png: it has 8-bit gray; 8-bit RGBA is needed");
    EXPECT_EQ(refused(file(ihdr(64, 64, 8, rgb), rows(192))),
              "2: cannot read a.png: it has 8-bit RGB without alpha; 8-bit RGBA is needed");
}

TEST(AtlasFile, RefusesOtherSizes) {
    EXPECT_EQ(refused(changed([](Png& png) {
                  png.image.height = 63;
                  png.image.rgba.resize(64 * 63 * 4);
              })),
              "2: cannot read a.png: it is no atlas: it has 64 x 63 pixels, not 64 x 64");
    EXPECT_EQ(refused(changed([](Png& png) {
                  png.image.width = 32;
                  png.image.height = 128;
              })),
              "2: cannot read a.png: it is no atlas: it has 32 x 128 pixels, not 64 x 64");
}

TEST(AtlasFile, RefusesPixelsThatAreNone) {
    const std::string row_0 =
        "2: cannot read a.png: row 0 is not the CIE 1931 observer of quantization thesis";
    EXPECT_EQ(refused(with_byte(0, 42, AtlasChannel::lamp, 152)), row_0);
    EXPECT_EQ(refused(with_byte(0, 63, AtlasChannel::material, 255)), row_0);
    EXPECT_EQ(refused(with_byte(0, 12, AtlasChannel::excitation, 254)), row_0);
    EXPECT_EQ(refused(with_byte(0, 0, AtlasChannel::alpha, 254)),
              "2: cannot read a.png: row 0: alpha is not 255");
    EXPECT_EQ(refused(with_byte(63, 63, AtlasChannel::alpha, 0)),
              "2: cannot read a.png: row 63: alpha is not 255");
    EXPECT_EQ(refused(with_byte(2, 5, AtlasChannel::excitation, 1)),
              "2: cannot read a.png: row 2: blue is not 0");
    EXPECT_EQ(refused(with_byte(4, 5, AtlasChannel::lamp, 1)),
              "2: cannot read a.png: row 4: red holds a lamp that has no name");
    EXPECT_EQ(refused(with_byte(3, 5, AtlasChannel::material, 1)),
              "2: cannot read a.png: row 3: green holds a material that has no name");
    EXPECT_EQ(refused(with_byte(1, 63, AtlasChannel::lamp, 254)),
              "2: cannot read a.png: row 1: the greatest value of lamp \"ramp\" is 254, not 255");
    EXPECT_EQ(refused(with_byte(1, 63, AtlasChannel::material, 254)), "no error");
}

TEST(AtlasFile, RefusesMissingTexts) {
    for (const std::string key : {"atlas", "observer", "lamps", "materials"})
        EXPECT_EQ(refused(changed([&](Png& png) { png.text.erase("metamer:" + key); })),
                  "2: cannot read a.png: it is no atlas: it has no text metamer:" + key);
}

TEST(AtlasFile, RefusesOtherVersionsAndObservers) {
    EXPECT_EQ(refused(with_text("atlas", "2")),
              "2: cannot read a.png: metamer:atlas is \"2\"; only \"1\" is known");
    EXPECT_EQ(refused(with_text("observer", "CIE 1964 10 degree")),
              "2: cannot read a.png: metamer:observer is \"CIE 1964 10 degree\"; only \"CIE 1931 2 degree\" "
              "is known");
}

// What is said of a line of the lamps; the sample's three are there with it.
std::string line_refused(const std::string& line) {
    const std::string refusal = refused(with_text("lamps", "1\tramp\t12.3\ta test\n" + line));
    const std::string opening = "2: cannot read a.png: metamer:lamps line 2: ";
    return refusal.starts_with(opening) ? refusal.substr(opening.size()) : refusal;
}

TEST(AtlasFile, RefusesLinesThatAreNone) {
    for (const char* line : {"\n", "garbage\n", "2\tline\n", "2\tline\t1\n"})
        EXPECT_EQ(line_refused(line), "it is not row, name, peak, source, with tabs between") << line;
    EXPECT_EQ(line_refused("2\tline\t1\ta test"), "it has no line feed");
    for (const std::string row : {"0", "64", "-1", "two", "", "2.0", "4294967298"})
        EXPECT_EQ(line_refused(row + "\tline\t1\ta test\n"), "row \"" + row + "\" is not 1 .. 63");
    for (const std::string peak : {"", "1,5", "nan", "inf", "1e999", "0x10", "1 2"})
        EXPECT_EQ(line_refused("2\tline\t" + peak + "\ta test\n"), "peak \"" + peak + "\" is not a number");
    EXPECT_EQ(line_refused("1\tline\t1\ta test\n"), "row 1 comes twice");
    EXPECT_EQ(line_refused("2\t\t1\ta test\n"), "the name is empty");
}

TEST(AtlasFile, RefusesNumbersAndNamesThatMakeNoSense) {
    const std::string lamps = "1\tramp\t12.3\ta test\n3\tthird\t1\ta test\n";
    // Found by scripts/fuzz: with a peak of 5e-324 a booth's levels were no numbers, with 1e+308 infinite.
    for (const std::string peak : {"0", "-1", "5e-324", "9e-36", "2e+35", "1e+308"})
        EXPECT_EQ(refused(with_text("lamps", lamps + "2\tline\t" + peak + "\ta test\n")),
                  "2: cannot read a.png: row 2: the peak " + peak + " is outside 1e-35 .. 1e+35");
    for (const std::string peak : {"1e-35", "1e+35"})
        EXPECT_EQ(refused(with_text("lamps", lamps + "2\tline\t" + peak + "\ta test\n")), "no error");
    for (const std::string scale : {"0", "-0.5", "1.5"}) {
        Png png = decode_png(encode_atlas(sample_atlas(Quantization::weighted)), "a.png");
        png.text["metamer:materials"] = "1\tgray\t1\t\n2\tblack\t" + scale + "\t\n";
        EXPECT_EQ(refused(encode_png(png, true)),
                  "2: cannot read a.png: row 2: the scale " + scale + " is outside 0 .. 1");
    }
    EXPECT_EQ(refused(with_text("materials", "1\tgray\t1\t\n2\tblack\t0.5\t\n")),
              "2: cannot read a.png: row 2: the scale 0.5 is not 1, as quantization thesis has it");
    EXPECT_EQ(refused(with_text("materials", "1\tgray\tmuch\t\n")),
              "2: cannot read a.png: metamer:materials line 1: scale \"much\" is not a number");
    EXPECT_EQ(refused(with_text("lamps", lamps + "2\tRamp\t1\ta test\n")),
              "2: cannot read a.png: two rows hold a lamp of the name \"Ramp\"");
    EXPECT_EQ(refused(with_text("materials", "1\tgray\t1\t\n2\tGRAY\t1\t\n")),
              "2: cannot read a.png: two rows hold a material of the name \"GRAY\"");
    EXPECT_EQ(refused(with_text("lamps", lamps + "2\tli\x1B[31mne\t1\ta test\n")),
              "2: cannot read a.png: row 2: the name or its source holds a control character");
    EXPECT_EQ(refused(with_text("lamps", lamps)),
              "2: cannot read a.png: row 2: red holds a lamp that has no name");
    EXPECT_EQ(refused(with_text("lamps", lamps + "2\tline\t1\ta test\n4\tnobody\t1\ta test\n")),
              "2: cannot read a.png: row 4: the greatest value of lamp \"nobody\" is 0, not 255");
}

TEST(AtlasFile, PassesOverOtherTexts) {
    EXPECT_EQ(refused(changed([](Png& png) { png.text["Title"] = "crayons"; })), "no error");
}

TEST(AtlasFile, WritesNothingThatItWouldNotRead) {
    Atlas atlas = sample_atlas();
    atlas.lamps[1].name = "a\tb";
    EXPECT_EQ(error_of([&] { encode_atlas(atlas); }),
              "2: cannot encode an atlas: row 1: the name or its source holds a control character");
    atlas = sample_atlas();
    atlas.lamps[0].name = "observer";
    EXPECT_EQ(error_of([&] { encode_atlas(atlas); }), "2: cannot encode an atlas: row 0 has a name");
    atlas = sample_atlas();
    atlas.lamps[1].peak = std::numeric_limits<double>::infinity();
    EXPECT_EQ(error_of([&] { encode_atlas(atlas); }),
              "2: cannot encode an atlas: row 1: the peak inf is outside 1e-35 .. 1e+35");
}

TEST(AtlasFile, ReadsFromDisk) {
    const auto path = std::filesystem::temp_directory_path() /
                      ("metamer-atlas-test-" + std::to_string(::getpid()) + ".png");
    write_file(path, encode_atlas(sample_atlas()));
    EXPECT_EQ(read_atlas(path).rgba, sample_atlas().rgba);
    write_file(path, std::string((4u << 20) + 1, 'x'));
    EXPECT_EQ(error_of([&] { read_atlas(path); }),
              "2: cannot read " + path.string() + ": it is over 4194304 bytes");
    std::filesystem::remove(path);
    EXPECT_EQ(error_of([&] { read_atlas(path); }),
              "2: cannot read " + path.string() + ": there is no such file");
}

} // namespace
} // namespace metamer
