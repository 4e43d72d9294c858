// metamer render: where frames go, what is refused, and that a failure leaves nothing behind.
#include "commands/command_test.h"
#include "image/png.h"

namespace metamer::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

class RenderOutput : public CommandTest {
protected:
    static std::vector<std::string> small(const std::string& output) {
        return {"render", "--output", output, "--size", "64x36", "--set", "display.supersample=1"};
    }
};

TEST_F(RenderOutput, SizesThatCannotBe) {
    const std::pair<const char*, const char*> cases[] = {
        {"0x0", "width = 0 is below 16; it may be 16 .. 4096 px"},
        {"640x0", "height = 0 is below 16; it may be 16 .. 4096 px"},
        {"640x99999", "height = 99999 is above 4096; it may be 16 .. 4096 px"},
        {"-640x360", "width = -640 is below 16; it may be 16 .. 4096 px"},
        {"64.5x36", "width = 64.5 is no whole number; it may be 16 .. 4096 px"},
        {"64xx36", "height = x36 is no whole number; it may be 16 .. 4096 px"},
        {"abc", "it must be WIDTHxHEIGHT in pixels, as in 1280x720"},
        {"640", "it must be WIDTHxHEIGHT in pixels, as in 1280x720"},
        {"640x", "it must be WIDTHxHEIGHT in pixels, as in 1280x720"},
        {"x360", "it must be WIDTHxHEIGHT in pixels, as in 1280x720"},
    };
    for (const auto& [size, cause] : cases)
        expect_failure(2, {"render", "--output", "x.png", "--size=" + std::string(size)},
                       "cannot read --size " + std::string(size) + ": " + cause);
}

TEST_F(RenderOutput, SetsThatCannotBe) {
    const std::pair<const char*, const char*> cases[] = {
        {"nonsense", "it must be section.key=value, as in lamp.1.spectrum=F11"},
        {"lamp.1.strength=-1", "strength = -1 is below 0; it may be 0 .. 1000000"},
        {"lamp.1.strenght=1", "unknown key \"strenght\" in [lamp.1]; did you mean \"strength\"?"},
        {"lamp.1.spectrum=F1l", "spectrum = F1l: the library has no such lamp; did you mean \"F11\"?"},
        {"compare.left.method=spectal",
         "left.method = spectal is none of auto, rgb, tristimulus, spectral, prefiltered, packed, reduced, "
         "folded; did you mean \"spectral\"?"},
    };
    for (const auto& [set, cause] : cases)
        expect_failure(2, {"render", "--output", "x.png", "--set", set},
                       "cannot read --set " + std::string(set) + ": " + cause);
}

TEST_F(RenderOutput, ExhibitsThatCannotBe) {
    write("noise.ini", std::string("\x89\0\xff\x01", 4));
    write("typo.ini", "[display]\nwidth = 64\nheigth = 32\n");
    fs::create_directories(folder_ / "folder.ini");
    const std::pair<const char*, const char*> cases[] = {
        {"missing.ini", "cannot read missing.ini: there is no such file"},
        {"folder.ini", "cannot read folder.ini: it is a folder"},
        {"typo.ini", "cannot read typo.ini:3: unknown key \"heigth\" in [display]; did you mean \"height\"?"},
        {"noise.ini", "cannot read noise.ini:1: a NUL byte; this is no text file"},
    };
    for (const auto& [file, message] : cases)
        expect_failure(2, {"render", file, "--output", "x.png"}, message);
}

// Every key has a default, and so an exhibit may say nothing at all.
TEST_F(RenderOutput, AnEmptyExhibitIsAllDefaults) {
    write("empty.ini", "");
    output_of({"render", "empty.ini", "--output", "x.png", "--size", "32x18"});
    EXPECT_THAT(files(), testing::ElementsAre("empty.ini", "x.png"));
}

TEST_F(RenderOutput, PlacesThatCannotBeWritten) {
    fs::create_directories(folder_ / "folder");
    expect_failure(2, small("none/x.png"), "cannot write none/x.png: there is no folder none");
    expect_failure(2, small("folder"), "cannot write folder: it is a folder");
    expect_failure(2, small(""), "cannot write \"\": it names no file");
    const std::string long_name(300, 'x');
    expect_failure(1, small(long_name), "cannot write " + long_name + ": File name too long");
}

TEST_F(RenderOutput, AnOldFileIsReplacedWhole) {
    write("x.png", std::string(1 << 20, 'x'));
    output_of(small("x.png"));
    EXPECT_EQ(decode_png(read("x.png"), "x.png").image.width, 64);
    EXPECT_THAT(files(), testing::ElementsAre("x.png"));
}

TEST_F(RenderOutput, ADiskThatFillsUpLeavesTheOldFile) {
    write("x.png", "old");
    expect_failure(1, {"render", "--output", "x.png", "--size", "640x360"},
                   "cannot write x.png: File too large", {.most_file_bytes = 2048});
    EXPECT_EQ(read("x.png"), "old");
}

// The file that a link leads to is replaced, not the link; a device is written to, never renamed over.
TEST_F(RenderOutput, LinksAndDevicesStay) {
    fs::create_directories(folder_ / "real");
    fs::create_symlink("real/x.png", folder_ / "link.png");
    write("real/x.png", "old");
    output_of(small("link.png"));
    EXPECT_TRUE(fs::is_symlink(folder_ / "link.png"));
    EXPECT_EQ(decode_png(read("real/x.png"), "x.png").image.width, 64);
    EXPECT_THAT(files(), testing::ElementsAre("link.png", "real", "real/x.png"));

    fs::create_symlink("/dev/full", folder_ / "full.png");
    expect_failure(1, small("full.png"), "cannot write full.png: No space left on device");
    EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST_F(RenderOutput, FullStandardOutputIsAnError) {
    const Outcome outcome = metamer({"list", "lamps"}, {.standard_output = "/dev/full"});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.err, "metamer: cannot write standard output: it took no more\n");
}

// glvnd without any driver: EGL has no display to give.
TEST_F(RenderOutput, WithoutEglNothingIsDrawn) {
    const World world{.environment = {{"__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent"}}};
    const auto message =
        AllOf(StartsWith("metamer: cannot open an OpenGL ES 2 context: surfaceless platform: "),
              HasSubstr("; first device: "), HasSubstr("; default display: "));
    expect_failure_like(3, small("x.png"), message, world);
    expect_failure_like(3, {"info", "--json"}, message, world);
    expect_failure_like(3, {"measure", "--lamp", "E", "--material", "crayon-red", "--json"}, message, world);
}

TEST_F(RenderOutput, WithoutEglBadInputIsStillBadInput) {
    const World world{.environment = {{"__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent"}}};
    expect_failure(2, {"render", "missing.ini", "--output", "x.png"},
                   "cannot read missing.ini: there is no such file", world);
}

// Numbers and messages are the same whatever the locale says, installed or not.
TEST_F(RenderOutput, TheLocaleChangesNothing) {
    const World german{.environment = {{"LC_ALL", "de_DE.UTF-8"}, {"LANGUAGE", "de"}}};
    expect_failure(1, small("/proc/x.png"), "cannot write /proc/x.png: No such file or directory", german);
    const std::vector<std::string> measure = {"measure",    "--lamp",     "gauss:530.5:20",
                                              "--material", "crayon-red", "--json"};
    EXPECT_EQ(metamer(measure, german).out, output_of(measure));
}

} // namespace
} // namespace metamer::test
