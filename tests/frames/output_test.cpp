// From light to code values: curves, colors outside the space, dithering, 24 and 16 bits.
#include <GLES2/gl2.h>
#include <cmath>
#include <gtest/gtest.h>
#include <set>

#include "frames/frames.h"
#include "gles/framebuffer.h"
#include "plan/twin.h"
#include "render/frame_renderer.h"

namespace metamer {
namespace {

constexpr int kWidth = 256, kHeight = 96;

/// From black to white: three bars of 32 rows; the first is linear in light from left to right.
Exhibit gray_ramp(const std::string& display) {
    return exhibit_of("[display]\nwidth = 256\nheight = 96\n" + display +
                      "[scene]\nkind = ramp\nmaterials = rgb:000000, rgb:FFFFFF\n[lamp.1]\nspectrum = D65\n"
                      "strength = 1.02\n");
}

Image drawn(const Exhibit& exhibit, DrawStyle style = {}) {
    const Surfaceless context;
    const Framebuffer target(kWidth, kHeight, DepthBuffer::depth16, color_buffer_of(exhibit.display));
    glEnable(GL_DITHER);
    FrameRenderer renderer(exhibit, style);
    target.bind();
    renderer.draw(kWidth, kHeight);
    EXPECT_FALSE(glIsEnabled(GL_DITHER)) << "each driver has its own";
    return {kWidth, kHeight, target.read_rgba()};
}

/// Green light of the first bar's column.
double light_at(const Twin& twin, const Exhibit& exhibit, int x) {
    const ObjectSetting& bar = exhibit.objects[0];
    const double t = (x + 0.5) / kWidth;
    Pixel black = twin.pixel_on(bar), white = black;
    white.material = twin.spectra().material(bar.material_end->key);
    return (1 - t) * twin.light(bar, black).g + t * twin.light(bar, white).g;
}

// Half a step of rounding, and round-off; the polynomial is up to 0.24 of a step off the standard, so a curve
// in the other's place fails.
template <class Curve>
void compare_curve(const Exhibit& exhibit, DrawStyle style, double slack, const Curve& curve) {
    const Image image = drawn(exhibit, style);
    const Twin twin(exhibit);
    for (int x = 0; x < kWidth; ++x) {
        const double code = 255 * curve(std::min(light_at(twin, exhibit, x), 1.0));
        EXPECT_NEAR(pixel(image, x, 16).g, code, 0.5 + slack) << x;
    }
}

TEST(OutputCurves, AreThoseOfTheColorRoom) {
    compare_curve(gray_ramp(""), {}, 0.04, [](double v) { return encode_by_polynomial(v); });
    compare_curve(gray_ramp(""), {.everybody = true}, 0.04,
                  [](double v) { return encode(Transfer::srgb, v); });
    compare_curve(gray_ramp("transfer = none\n"), {}, 0.04, [](double v) { return v; });
}

TEST(OutputCurves, ThePolynomialIsWithinHalfAStepOfTheStandard) {
    compare_curve(gray_ramp(""), {}, 0.3, [](double v) { return encode(Transfer::srgb, v); });
}

// Pure lines are outside of every working space; strong ones are too bright besides.
TEST(KeepHue, IsItsTwinByEveryMethod) {
    const Surfaceless context;
    int apart = 0;
    for (const MethodInfo& info : kMethods)
        for (const char* lamp : {"line:510", "line:589", "line:450", "D65"})
            for (const double strength : {0.3, 5.0}) {
                Exhibit exhibit = exhibit_of(
                    "[display]\nwidth = 64\nheight = 64\ngamut = keep-hue\n[accuracy]\nmethod = " +
                    std::string(info.name) + "\n[scene]\nkind = patches\nmaterials = rgb:FF8833\n" +
                    "[lamp.1]\nspectrum = " + lamp + "\n");
                exhibit.lamps[0].strength = strength;
                const EncodedRgb8 kept = pixel(render_frame(exhibit), 32, 32);
                const Twin twin(exhibit);
                const LinearRgb light = twin.light(exhibit.objects[0], twin.pixel_on(exhibit.objects[0]));
                const EncodedRgb8 expected = encode_rgb8(Transfer::srgb, kept_hue(light));
                EXPECT_LE(steps(kept, expected), 1)
                    << info.name << ' ' << lamp << ' ' << strength << ": drawn " << text_of(kept) << ", twin "
                    << text_of(expected);
                exhibit.display.gamut = Gamut::clip;
                apart += steps(kept, pixel(render_frame(exhibit), 32, 32)) > 40;
            }
    EXPECT_GT(apart, 20) << "clipping shows another color";
}

/// A frame of one gray at many strengths: means of the green codes over a tile of 8 x 8, less the code before
/// rounding; in steps of `levels`. The greatest.
double worst_tile(Exhibit exhibit, double levels) {
    const Surfaceless context;
    const Framebuffer target(16, 16, DepthBuffer::none, color_buffer_of(exhibit.display));
    FrameRenderer renderer(exhibit);
    double worst = 0;
    for (int i = 1; i < 20; ++i) {
        exhibit.lamps[0].strength = 0.047 * i;
        renderer.update();
        target.bind();
        renderer.draw(16, 16);
        const Image image{16, 16, target.read_rgba()};
        double sum = 0;
        for (int y = 0; y < 8; ++y)
            for (int x = 0; x < 8; ++x)
                sum += pixel(image, x, y).g;
        const Twin twin(exhibit);
        const double exact =
            encode_by_polynomial(twin.light(exhibit.objects[0], twin.pixel_on(exhibit.objects[0])).g);
        worst = std::max(worst, std::abs(sum / 64 / 255 - exact) * levels);
    }
    return worst;
}

class Dither : public testing::TestWithParam<int> {};

// Thresholds are 1/64 of a step apart: a tile of one color comes within 1/128, and round-off.
TEST_P(Dither, ATilesMeanIsTheLightBeforeRounding) {
    const double levels = GetParam() == 16 ? 63 : 255;
    Exhibit exhibit =
        exhibit_of("[display]\nwidth = 16\nheight = 16\ncolor_depth = " + std::to_string(GetParam()) +
                   "\n[scene]\nkind = patches\nmaterials = rgb:FFFFFF\n[lamp.1]\nspectrum = D65\n");
    // llvmpipe cuts RGB565 off 8 bits instead of rounding: 255/4 where 63 is right, up to 0.38 of a step off.
    const bool coarse = GetParam() == 16;
    EXPECT_GT(worst_tile(exhibit, levels), coarse ? 0.7 : 0.25) << "without it";
    exhibit.display.dither = true;
    EXPECT_LT(worst_tile(exhibit, levels), coarse ? 0.4 : 0.03);
}

INSTANTIATE_TEST_SUITE_P(Bits, Dither, testing::Values(24, 16));

TEST(Dither565, HasTheLevelsOfSixteenBits) {
    const Image image = drawn(gray_ramp("color_depth = 16\n"));
    std::set<int> red, green;
    for (int x = 0; x < kWidth; ++x) {
        red.insert(pixel(image, x, 16).r);
        green.insert(pixel(image, x, 16).g);
    }
    EXPECT_LE(red.size(), 32u);
    EXPECT_GT(green.size(), 40u);
    EXPECT_LE(green.size(), 64u);
}

} // namespace
} // namespace metamer
