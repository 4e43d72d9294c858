// metamer render: what is drawn. What is written where, and what is refused: render_output_test.cpp.
#include "color/working_space.h"
#include "commands/command_test.h"
#include "image/png.h"

namespace metamer::test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

// Lamp and materials of files beside it, an unlit scene without halves: one patch fills the frame.
constexpr const char* kPatches = "[display]\nwidth = 32\nheight = 32\n[scene]\nkind = patches\n"
                                 "materials = two.csv#half\n[lamp.1]\nspectrum = lamp.csv\n";

class Render : public CommandTest {
protected:
    Render() {
        fs::create_directories(folder_ / "show");
        write("show/patches.ini", kPatches);
        write("show/lamp.csv", kFlatLamp);
        write("show/two.csv", kTwoMaterials);
    }

    Png frame(const std::string& name) const { return decode_png(read(name), name); }

    /// Renders and reads back; stderr may hold warnings.
    Png rendered(std::vector<std::string> arguments, World world = {}) const {
        arguments.insert(arguments.begin(), "render");
        arguments.insert(arguments.end(), {"--output", (folder_ / "frame.png").string()});
        const Outcome outcome = metamer(arguments, std::move(world));
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        return frame("frame.png");
    }

    static std::vector<int> pixel(const Image& image, int x, int y) {
        const auto at = image.rgba.begin() + (static_cast<std::ptrdiff_t>(y) * image.width + x) * 4;
        return {at, at + 3};
    }
};

TEST_F(Render, WithoutAnExhibitDrawsTheBuiltInOne) {
    const std::string out = output_of({"render", "--output", "x.png", "--size", "96x54"});
    EXPECT_THAT(out, StartsWith("x.png: 96 x 54 px, drawn by "));
    const Png png = frame("x.png");
    EXPECT_EQ(png.image.width, 96);
    EXPECT_EQ(png.image.height, 54);
    EXPECT_EQ(png.text.at("Title"), "the built-in crayons.ini");
    EXPECT_EQ(png.text.at("Software"), "Metamer");
}

TEST_F(Render, TheBuiltInExhibitIsTheShippedCrayons) {
    const Png shipped = rendered({METAMER_SOURCE_DIR "/config/crayons.ini", "--size", "96x54"});
    EXPECT_EQ(rendered({"--size", "96x54"}).image.rgba, shipped.image.rgba);
}

TEST_F(Render, TheSizeIsTheExhibitsUnlessAsked) {
    const Image own = rendered({"show/patches.ini"}).image;
    EXPECT_EQ(own.width, 32);
    EXPECT_EQ(own.height, 32);
    const Image asked = rendered({"show/patches.ini", "--size", "48X20"}).image;
    EXPECT_EQ(asked.width, 48);
    EXPECT_EQ(asked.height, 20);
}

TEST_F(Render, TheSameExhibitGivesTheSameBytes) {
    output_of({"render", "-o", "a.png", "--size", "96x54"});
    output_of({"render", "-o", "b.png", "--size", "96x54"});
    EXPECT_EQ(read("a.png"), read("b.png"));
}

TEST_F(Render, PathsInAnExhibitStartAtItsFolder) {
    const Image here = rendered({"show/patches.ini"}).image;
    const Image elsewhere = rendered({(folder_ / "show/patches.ini").string()}, {.folder = "/"}).image;
    EXPECT_EQ(here.rgba, elsewhere.rgba);
    const Image inside = rendered({"patches.ini"}, {.folder = folder_ / "show"}).image;
    EXPECT_EQ(here.rgba, inside.rgba);
}

TEST_F(Render, PathsInSetStartAtTheCurrentFolder) {
    write("red.csv", "wavelength_nm,red\n400,0\n600,0\n610,1\n700,1\n");
    const Image red = rendered({"show/patches.ini", "--set", "lamp.1.spectrum=red.csv"}).image;
    const auto color = pixel(red, 16, 16);
    EXPECT_GT(color[0], 200);
    EXPECT_EQ(color[2], 0);
    expect_failure(2,
                   {"render", "show/patches.ini", "--set", "lamp.1.spectrum=lamp.csv", "--output", "y.png"},
                   "cannot read --set lamp.1.spectrum=lamp.csv: spectrum = lamp.csv: there is no such file");
}

TEST_F(Render, LaterSetsWinAndAnEmptyOneTakesOut) {
    const Image plain = rendered({"show/patches.ini"}).image;
    const Image dim = rendered({"show/patches.ini", "--set", "lamp.1.strength=0.25"}).image;
    EXPECT_LT(pixel(dim, 16, 16)[1], pixel(plain, 16, 16)[1]);
    const Image later =
        rendered({"show/patches.ini", "--set", "lamp.1.strength=9", "--set", "lamp.1.strength=0.25"}).image;
    EXPECT_EQ(later.rgba, dim.rgba);
    const Image out =
        rendered({"show/patches.ini", "--set", "lamp.1.strength=9", "--set", "lamp.1.strength="}).image;
    EXPECT_EQ(out.rgba, plain.rgba);
}

TEST_F(Render, DarknessIsBlack) {
    const Image dark = rendered({"show/patches.ini", "--set", "lamp.1.strength=0"}).image;
    for (std::size_t i = 0; i < dark.rgba.size(); ++i)
        ASSERT_EQ(dark.rgba[i], i % 4 == 3 ? 255 : 0) << "byte " << i;
}

// What a patch shows is what `measure` says of the pair, on both sides of the split.
TEST_F(Render, PatchesShowWhatMeasureSays) {
    const Image image =
        rendered({"--size", "32x32", "--set", "scene.kind=patches", "--set", "scene.materials=crayon-orange",
                  "--set", "display.supersample=1", "--set", "display.adaptation=none", "--set",
                  "lamp.1.spectrum=F11", "--set", "compare.left.method=rgb"})
            .image;
    const auto pair = json_of({"measure", "--lamp", "F11", "--material", "crayon-orange", "--json"});
    EXPECT_EQ(pixel(image, 4, 16), pair["methods"][0]["gpu_rgb8"].get<std::vector<int>>());
    EXPECT_EQ(pixel(image, 28, 16), pair["methods"][2]["gpu_rgb8"].get<std::vector<int>>());
    EXPECT_NE(pixel(image, 4, 16), pixel(image, 28, 16));
}

TEST_F(Render, DoubtsAreWarningsOnStderr) {
    write("wide.csv", "wavelength_nm,wide\n300,1\n1000,1\n");
    const Outcome outcome =
        metamer({"render", "show/patches.ini", "--set", "lamp.1.spectrum=wide.csv", "--output", "frame.png"});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_THAT(outcome.err, StartsWith("metamer: warning: "));
    EXPECT_THAT(outcome.err, HasSubstr("of its energy lies outside the grid (385..700 nm) and is lost\n"));
    EXPECT_THAT(outcome.out, StartsWith("frame.png: 32 x 32 px"));
}

class RenderSpaces : public Render, public testing::WithParamInterface<std::string> {};

// The chunks of PNG 1.2 (sections 4.2.2.1-4.2.2.3): sRGB for sRGB itself, else the curve's exponent and the
// space's own chromaticities, which are kept to 1e-5.
TEST_P(RenderSpaces, TheColorChunksAreTheSpaces) {
    const WorkingSpace& space = *find_working_space(GetParam());
    const std::string set = "display.working_space=" + GetParam();
    const ColorChunks color = rendered({"show/patches.ini", "--set", set}).color;
    const ColorChunks linear =
        rendered({"show/patches.ini", "--set", set, "--set", "display.transfer=none"}).color;
    EXPECT_EQ(color.srgb, GetParam() == "sRGB-D65");
    EXPECT_FALSE(linear.srgb);
    EXPECT_NEAR(linear.gamma, 1, 1e-5);
    const std::array<double, 8> xy{space.white.x, space.white.y, space.red.x,  space.red.y,
                                   space.green.x, space.green.y, space.blue.x, space.blue.y};
    ASSERT_TRUE(linear.xy.has_value());
    EXPECT_THAT(*linear.xy, testing::Pointwise(testing::DoubleNear(1.1e-5), xy));
    if (color.srgb)
        return;
    EXPECT_NEAR(color.gamma, 1 / 2.2, 1e-5);
    ASSERT_TRUE(color.xy.has_value());
    EXPECT_THAT(*color.xy, testing::Pointwise(testing::DoubleNear(1.1e-5), xy));
}

INSTANTIATE_TEST_SUITE_P(All, RenderSpaces,
                         testing::Values("sRGB-D65", "sRGB-D50", "sRGB-E", "CIE-RGB-E", "Adobe-D65",
                                         "Apple-D50", "Apple-D65", "NTSC-C", "PAL-D65"),
                         [](const auto& space) {
                             std::string name = space.param;
                             name.erase(std::remove(name.begin(), name.end(), '-'), name.end());
                             return name;
                         });

} // namespace
} // namespace metamer::test
