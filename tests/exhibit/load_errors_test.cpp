// Every message that a wrong exhibit gets, and the limits of every range.
#include <gmock/gmock.h>

#include "base/files.h"
#include "exhibit/scene_kinds.h"
#include "exhibit/support.h"
#include "image/png.h"

namespace metamer {
namespace {

struct Case {
    const char* text;
    const char* message; ///< after "cannot read k.ini:"
};

void expect_messages(std::initializer_list<Case> cases) {
    for (const Case& c : cases)
        EXPECT_EQ(error_of([&] { exhibit_of(c.text); }), std::string("cannot read k.ini:") + c.message)
            << c.text;
}

TEST(LoadErrors, Display) {
    expect_messages({
        {"[display]\nwidth = 15\n", "2: width = 15 is below 16; it may be 16 .. 4096 px"},
        {"[display]\nwidth = 4097\n", "2: width = 4097 is above 4096; it may be 16 .. 4096 px"},
        {"[display]\nheight = tall\n", "2: height = tall is no whole number; it may be 16 .. 4096 px"},
        {"[display]\nheight = 100.5\n", "2: height = 100.5 is no whole number; it may be 16 .. 4096 px"},
        {"[display]\nheight =\n", "2: height =  is no whole number; it may be 16 .. 4096 px"},
        {"[display]\nworking_space = sRGB-D66\n", "2: working_space = sRGB-D66 is none of sRGB-D65, "
                                                  "sRGB-D50, sRGB-E, CIE-RGB-E, Adobe-D65, Apple-D50, "
                                                  "Apple-D65, NTSC-C, PAL-D65; did you mean \"sRGB-D65\"?"},
        {"[display]\nmatrix = 1 2 3 4 5 6 7 8\n",
         "2: matrix = 1 2 3 4 5 6 7 8 is 8 numbers; it may be 9 numbers, -100 .. 100"},
        {"[display]\nmatrix = 1 2 3 4 5 6 7 8 x\n",
         "2: matrix = 1 2 3 4 5 6 7 8 x has \"x\", which is no number; it may be 9 numbers, -100 .. 100"},
        {"[display]\nmatrix = 1 2 3 4 5 6 7 8 9\n",
         "2: matrix = 1 2 3 4 5 6 7 8 9 is singular: some colors would be lost"},
        {"[display]\nmatrix = 1 0 0 0 1 0 0 0 101\n",
         "2: matrix = 1 0 0 0 1 0 0 0 101 has 101, which is above 100; it may be 9 numbers, -100 .. 100"},
        {"[display]\nworking_space = sRGB-E\nmatrix = 1 0 0 0 1 0 0 0 1\n",
         "3: matrix stands in place of working_space, which k.ini:2 gives"},
        {"[display]\ntransfer = gamma\n", "2: transfer = gamma is none of srgb, none"},
        {"[display]\nadaptation = bradfort\n",
         "2: adaptation = bradfort is none of none, bradford; did you mean \"bradford\"?"},
        {"[display]\ngamut = clop\n", "2: gamut = clop is none of clip, keep-hue; did you mean \"clip\"?"},
        {"[display]\ncolor_depth = 18\n", "2: color_depth = 18 is none of 24, 16; did you mean \"16\"?"},
        {"[display]\ndither = a bit\n", "2: dither = a bit is neither yes nor no"},
        {"[accuracy]\ntolerance = 0\n", "2: tolerance = 0 is below 0.01; it may be 0.01 .. 100 CIEDE2000"},
        {"[accuracy]\ntolerance = 101\n", "2: tolerance = 101 is above 100; it may be 0.01 .. 100 CIEDE2000"},
        {"[accuracy]\ntolerance = nan\n", "2: tolerance = nan is no number; it may be 0.01 .. 100 CIEDE2000"},
        {"[accuracy]\ntaps = 7\n", "2: taps = 7 is none of 4, 6, 8, 12, 16, 24, 32"},
        {"[display]\nsupersample = 3\n", "2: supersample = 3 is above 2; it may be 1 .. 2"},
        {"[atlas]\nquantization = wighted\n",
         "2: quantization = wighted is none of thesis, weighted; did you mean \"weighted\"?"},
        {"[accuracy]\nmethod = spectal\n", "2: method = spectal is none of auto, rgb, tristimulus, spectral, "
                                           "prefiltered, packed, reduced, folded; "
                                           "did you mean \"spectral\"?"},
        {"[atlas]\nfile = none.png\n", "2: file = none.png: there is no such file"},
    });
}

TEST(LoadErrors, KeysOfLaterIssuesAreUnknown) {
    expect_messages({
        {"[display]\nicc = a.icc\n", "2: unknown key \"icc\" in [display]"},
        {"[sky]\nhour = 3\n", "1: unknown section [sky]"},
    });
}

TEST(LoadErrors, Lamps) {
    expect_messages({
        {"[lamp.1]\nspectrum = F13\n",
         "2: spectrum = F13: the library has no such lamp; did you mean \"F11\"?"},
        {"[lamp.1]\nspectrum = 3\n",
         "2: spectrum = 3: a key names a row of an atlas; [atlas] file names none"},
        {"[lamp.1]\nspectrum = no/lamp.csv\n", "2: spectrum = no/lamp.csv: there is no such file"},
        {"[lamp.1]\nstrength = -1\n", "2: strength = -1 is below 0; it may be 0 .. 1000000"},
        {"[lamp.1]\nstrength = 1000001\n", "2: strength = 1000001 is above 1000000; it may be 0 .. 1000000"},
        {"[lamp.1]\nstrength = nan\n", "2: strength = nan is no number; it may be 0 .. 1000000"},
        {"[lamp.1]\nstrength = 1,5\n", "2: strength = 1,5 is no number; it may be 0 .. 1000000"},
        {"[lamp.1]\nposition = 1 2\n",
         "2: position = 1 2 is 2 numbers; it may be 3 numbers, -100 .. 100 scene units"},
        {"[lamp.1]\ndirection = 0 0 0\n", "2: direction = 0 0 0 has no length: light must travel somewhere"},
        {"[lamp.1]\nposition = 1 2 3\ndirection = 0 0 1\n",
         "3: [lamp.1] has a direction and, at k.ini:2, a position; one of them"},
        {"[lamp.1]\nposition = 1 2 3\nfalloff = 0 0 0\n",
         "3: falloff = 0 0 0 is all 0: the lamp would be infinitely bright"},
        {"[lamp.1]\nposition = 1 2 3\nfalloff = 1 -1 0\n",
         "3: falloff = 1 -1 0 has -1, which is below 0; it may be 3 numbers, 0 .. 1000000"},
        {"[lamp.1]\nfalloff = 1 0 1\n",
         "2: falloff = 1 0 1 asks for a position: without one there is no distance"},
        {"[lamp.1]\nshadow = maybe\n", "2: shadow = maybe is neither yes nor no"},
        {"[lamp.2]\nstrength = 1\n", "1: [lamp.2] without [lamp.1]; lamps are numbered from 1 without gaps"},
        {"[lamp.1]\n[lamp.4]\n[lamp.2]\n",
         "2: [lamp.4] without [lamp.3]; lamps are numbered from 1 without gaps"},
        {"[lamp.9]\nstrength = 1\n", "1: unknown section [lamp.9]; lamps are [lamp.1] .. [lamp.8]"},
        {"[lamp.1]\nshadow=1\n[lamp.2]\nshadow=1\n[lamp.3]\nshadow=1\n[lamp.4]\nshadow=1\n[lamp.5]\nshadow="
         "1\n",
         "10: shadow of a fifth lamp; at most 4 may cast shadows"},
    });
}

TEST(LoadErrors, SceneAndObjects) {
    expect_messages({
        {"[scene]\nkind = loaff\n", "2: kind = loaff is none of loaf, crayons, still-life, ramp, patches, "
                                    "media, corner, booth; did you mean \"loaf\"?"},
        {"[scene]\nmaterials = crayon-rod\n",
         "2: materials = crayon-rod: the library has no such material; did you mean \"crayon-red\"?"},
        {"[scene]\nmaterials = cc-red, crayon-rod\n",
         "2: materials: crayon-rod: the library has no such material; did you mean "
         "\"crayon-red\"?"},
        {"[scene]\nmaterials = cc-red,, cc-blue\n",
         "2: materials = cc-red,, cc-blue has an empty name between its commas"},
        {"[scene]\nmaterials =\n", "2: materials =  is 0 materials; scene crayons takes 1 .. 63"},
        {"[scene]\nkind = ramp\nmaterials = crayons\n",
         "3: materials = crayons is 15 materials; scene ramp takes exactly 2"},
        {"[scene]\nmaterials = single, cc-red\n",
         "2: materials = single, cc-red is 64 materials; scene crayons takes 1 .. 63"},
        {"[scene]\nkind = still-life\n[object.bal]\nspecular = 1\n",
         "3: scene still-life has no object \"bal\"; did you mean \"ball\"?"},
        {"[object.crayon-1]\n[object.crayon-white]\n",
         "2: [object.crayon-white] and [object.crayon-1] mean the same object, crayon-1"},
        {"[object.crayon-1]\nmaterial = 7\n",
         "2: material = 7: a key names a row of an atlas; [atlas] file names none"},
        {"[object.crayon-1]\nspecular = 1.5\n", "2: specular = 1.5 is above 1; it may be 0 .. 1"},
        {"[object.crayon-1]\nshininess = 0.5\n", "2: shininess = 0.5 is below 1; it may be 1 .. 1000"},
        {"[object.crayon-1]\nbump_height = 0.5\n", "2: bump_height = 0.5 asks for a bump map: bump = FILE"},
        {"[object.crayon-1]\nluminance_map = none.png\n",
         "2: luminance_map = none.png: there is no such file"},
        {"[object.crayon-1]\nluminance_map = maps\n", "2: luminance_map = maps: it is a folder"},
        {"[scene]\nkind = ramp\n[object.ramp-xyz]\nbump = maps/weave.png\n",
         "4: bump = maps/weave.png cannot be carried by a ramp"},
        {"[scene]\nmaterials = cc-red, cc-blue\n[object.crayon-1]\nkey_map = maps/beach-ball.png\n",
         "4: key_map = maps/beach-ball.png has key 3 at pixel 64, 8; no material has that key"},
    });
}

TEST(LoadErrors, MediaAndCorners) {
    const std::string media = "[scene]\nkind = media\n", corner = "[scene]\nkind = corner\n";
    const std::pair<std::string, const char*> cases[] = {
        {"[object.crayon-1]\nmedium = glass-cobalt\n",
         "2: medium = glass-cobalt is for the glass and the liquid of scene media"},
        {media + "[object.board]\nmedium = glass-cobalt\n",
         "4: medium = glass-cobalt is for the glass and the liquid of scene media"},
        {media + "[object.board]\nthickness = 1\n",
         "4: thickness = 1 is for the glass and the liquid of scene media"},
        {corner + "[object.wall]\nthickness = 1\n",
         "4: thickness = 1 is for the glass and the liquid of scene media"},
        {media + "[object.wedge]\nthickness = -1\n", "4: thickness = -1 is below 0; it may be 0 .. 1000"},
        {media + "[object.wedge]\nthickness = 1001\n",
         "4: thickness = 1001 is above 1000; it may be 0 .. 1000"},
        {media + "[object.wedge]\nmedium = glass-cobald\n",
         "4: medium = glass-cobald: the library has no such material; did you mean \"glass-cobalt\"?"},
        {media + "[object.wedge]\nluminance_map = maps/weave.png\n",
         "4: luminance_map = maps/weave.png cannot be carried by the things of scene media"},
        {corner + "[object.wall]\nbump = maps/weave.png\n",
         "4: bump = maps/weave.png cannot be carried by the things of scene corner"},
        {corner + "[object.floor]\nkey_map = maps/beach-ball.png\n",
         "4: key_map = maps/beach-ball.png cannot be carried by the things of scene corner"},
        {corner + "[lamp.1]\nposition = 1 1 1\n", "4: position = 1 1 1 is not for scene corner, whose walls "
                                                  "are lit evenly: give the lamp a direction"},
        {corner + "materials = crayons\n",
         "3: materials = crayons is 15 materials; scene corner takes exactly 2"},
    };
    for (const auto& [text, message] : cases)
        EXPECT_EQ(error_of([&] { exhibit_of(text); }), std::string("cannot read k.ini:") + message) << text;
    EXPECT_EQ(error_of([&] { exhibit_of(corner + "[lamp.1]\ndirection = 1 -1 -1\nshadow = yes\n"); }),
              "no error");
}

TEST(LoadErrors, Compare) {
    expect_messages({
        {"[compare]\nsplit = 1.5\n",
         "2: split = 1.5 is above 1; it may be 0 .. 1 of the width, or 0px .. the width"},
        {"[compare]\nsplit = half\n",
         "2: split = half is no number; it may be 0 .. 1 of the width, or 0px .. the width"},
        {"[display]\nwidth = 800\n[compare]\nsplit = 801px\n",
         "4: split = 801px is no column of the picture; it may be 0px .. 800px"},
        {"[compare]\nsplit = -1px\n", "2: split = -1px is no column of the picture; it may be 0px .. 1280px"},
        {"[compare]\nsplit = 1.5px\n",
         "2: split = 1.5px is no column of the picture; it may be 0px .. 1280px"},
        {"[compare]\nline = 65\n", "2: line = 65 is above 64; it may be 0 .. 64 px"},
        {"[compare]\nleft.lamp = krypto\n",
         "2: left.lamp = krypto: the library has no such lamp; did you mean \"krypton\"?"},
        {"[compare]\nright.strength = -0.5\n", "2: right.strength = -0.5 is below 0; it may be 0 .. 1000000"},
        {"[compare]\nleft.transfer = srgb\n",
         "2: unknown key \"left.transfer\" in [compare]; did you mean \"left.strength\"?"},
    });
}

TEST(LoadErrors, OverridesAreTheirOwnPlace) {
    EXPECT_EQ(
        error_of([] { exhibit_of("[lamp.1]\nspectrum = A\n", {"lamp.1.spectrum=krypto"}); }),
        "cannot read --set lamp.1.spectrum=krypto: spectrum = krypto: the library has no such lamp; did "
        "you mean "
        "\"krypton\"?");
    EXPECT_EQ(error_of([] { exhibit_of("", {"lamp.2.strength=1"}); }),
              "cannot read --set lamp.2.strength=1: [lamp.2] without [lamp.1]; lamps are numbered from 1 "
              "without gaps");
}

TEST(LoadErrors, ASpectrumFilesOwnLineIsKept) {
    const TestFolder folder;
    write_file(folder / "lamp.csv", "wavelength_nm,tube\n380,1\n400,-1\n");
    write_file(folder / "a.ini", "[lamp.1]\nspectrum = lamp.csv\n");
    const std::string ini = (folder / "a.ini").string(), csv = (folder / "lamp.csv").string();
    EXPECT_THAT(error_of([&] { load_exhibit(folder / "a.ini", with_quick_rows()); }),
                testing::StartsWith("cannot read " + ini + ":2: spectrum = lamp.csv: " + csv + ":3: "));
    // Of a list only the piece at fault is quoted.
    write_file(folder / "a.ini", "[kiosk]\nlamps = D65, F11, lamp.csv, A2800\n");
    EXPECT_THAT(error_of([&] { load_exhibit(folder / "a.ini", with_quick_rows()); }),
                testing::StartsWith("cannot read " + ini + ":2: lamps: " + csv + ":3: "));
}

TEST(LoadErrors, MapsHaveSidesOfPowersOfTwo) {
    const TestFolder folder;
    const auto message = [&](int width, int height) {
        Png png;
        png.image = {width, height,
                     std::vector<std::uint8_t>(static_cast<std::size_t>(width * height) * 4, 255)};
        write_file(folder / "map.png", encode_png(png, false));
        write_file(folder / "a.ini", "[object.crayon-1]\nluminance_map = map.png\n");
        return error_of([&] { load_exhibit(folder / "a.ini", with_quick_rows()); });
    };
    EXPECT_EQ(message(2048, 1), "no error");
    EXPECT_EQ(message(1, 64), "no error");
    const std::string place =
        "cannot read " + (folder / "a.ini").string() + ":2: luminance_map = map.png is ";
    const std::string rule = " pixels; the sides of a map are powers of two up to 2048";
    EXPECT_EQ(message(100, 64), place + "100 x 64" + rule);
    EXPECT_EQ(message(64, 3), place + "64 x 3" + rule);
    EXPECT_EQ(message(4096, 1), place + "4096 x 1" + rule);
    write_file(folder / "map.png", "no picture");
    EXPECT_THAT(
        error_of([&] { load_exhibit(folder / "a.ini", with_quick_rows()); }),
        testing::StartsWith("cannot read " + (folder / "a.ini").string() + ":2: luminance_map = map.png: "));
}

TEST(LoadErrors, KeyZeroIsTheObserversRow) {
    const TestFolder folder;
    Png png;
    png.image = {1, 1, {0, 0, 0, 255}};
    write_file(folder / "map.png", encode_png(png, false));
    write_file(folder / "a.ini", "[object.crayon-1]\nkey_map = map.png\n");
    EXPECT_EQ(error_of([&] { load_exhibit(folder / "a.ini", with_quick_rows()); }),
              "cannot read " + (folder / "a.ini").string() +
                  ":2: key_map = map.png has key 0 at pixel 0, 0; no material has that key");
}

TEST(LoadErrors, ValuesAtTheirLimitsAreTaken) {
    for (const char* set : {"display.width=16",
                            "display.width=4096",
                            "display.height=16",
                            "display.height=4096",
                            "lamp.1.strength=0",
                            "lamp.1.strength=1e6",
                            "display.supersample=1",
                            "display.supersample=2",
                            "accuracy.tolerance=0.01",
                            "accuracy.tolerance=100",
                            "accuracy.taps=4",
                            "accuracy.taps=32",
                            "object.crayon-1.specular=0",
                            "object.crayon-1.specular=1",
                            "object.crayon-1.shininess=1",
                            "object.crayon-1.shininess=1000",
                            "compare.split=0",
                            "compare.split=1",
                            "compare.split=0px",
                            "compare.split=1280px",
                            "compare.line=64",
                            "lamp.1.position=-100 0 100",
                            "scene.materials=single",
                            "scene.materials=cc-red"})
        EXPECT_EQ(error_of([&] { exhibit_of("", {set}); }), "no error") << set;
    EXPECT_EQ(
        error_of([] {
            exhibit_of(
                "[lamp.1]\nshadow=yes\n[lamp.2]\nshadow=on\n[lamp.3]\nshadow=true\n[lamp.4]\nshadow=1\n"
                "[lamp.5]\nshadow=no\n[lamp.6]\nshadow=off\n[lamp.7]\nshadow=false\n[lamp.8]\nshadow=0\n");
        }),
        "no error");
}

TEST(LoadErrors, LongValuesAreCutInMessages) {
    const std::string message =
        error_of([] { exhibit_of("[display]\nwidth = " + std::string(4000, '9') + "\n"); });
    EXPECT_LT(message.size(), 250u);
}

} // namespace
} // namespace metamer
