#include "methods/numbers.h"

#include <gtest/gtest.h>

#include "color/difference.h"
#include "methods/stock.h"

namespace metamer::test {
namespace {

double error_of(Method method, const Pixel& pixel) {
    Sight sight = stock().sight();
    sight.seen = sight.exact; // what is tested is the product, not the observer's eight bits
    const Pixel known = rows_only(pixel);
    return delta_e_2000(shade_xyz<double>(method, known, sight), exact_xyz(known, stock().exact()));
}

TEST(Prefiltered, IsExactUnderItsDominantLamp) {
    for (const char* lamp : {"A2800", "F11", "krypton", "D65"})
        for (const char* material : {"cc-red", "cc-cyan", "crayon-black"})
            EXPECT_LT(error_of(Method::prefiltered, stock().pair(lamp, material)), 1e-6) << lamp << material;
    Pixel second = stock().pair("A2800", "cc-cyan");
    second.lamps[0].strength = 1e-3;
    second.lamps.push_back(stock().lamp("F11"));
    EXPECT_GT(error_of(Method::prefiltered, second), 1) << "the first is the dominant one";
}

// Two lines whose parts of the third primary cancel: a quotient by what is left of it would be anything.
TEST(Prefiltered, APrimaryThatTheLampLacksIsThatOfEqualEnergy) {
    const auto third = [](const Emission& lamp) {
        return lamp_numbers(Method::prefiltered, lamp, stock().exact(), {})[2];
    };
    Emission yellow, red, both;
    yellow.value[35] = red.value[43] = 1; // 560 nm, 600 nm
    const double y = grid_k(yellow, stock().exact()) * third(yellow),
                 r = grid_k(red, stock().exact()) * third(red);
    ASSERT_LT(y * r, 0);
    both.value[35] = 1;
    both.value[43] = -y / r * (1 + 1e-6);
    OutputSpace output;
    output.dominant = &both;
    const Reflectance& material = *stock().layer("cc-red").row;
    const auto numbers = material_numbers(Method::prefiltered, material, stock().exact(), output);
    const auto equal = kSharpFromXyz * [](const Xyz& c) {
        return std::array{c.x, c.y, c.z};
    }(material_xyz(material, stock().exact()));
    EXPECT_EQ(numbers[2], equal[2]);
    EXPECT_NE(numbers[0], equal[0]) << "of which it has enough";
    EXPECT_LT(error_of(Method::prefiltered, stock().pair("NIST-LPS", "cc-blue")), 0.5);
}

// The identity of the thesis, exact on the grid: S = 1 of every lamp. A medium and a second wall are
// excluded: their light is a product of spectra, and the sum of a product is not the product of the sums.
TEST(Tristimulus, IsExactUnderEqualEnergyOnly) {
    Pixel pixel = stock().pair("E", "cc-cyan", 2);
    pixel.lamps[0].light = {0.5, 0.25, 0};
    pixel.lamps.push_back(stock().lamp("E", 0.5, {0.25, 0.5, 0}));
    EXPECT_LT(error_of(Method::tristimulus, pixel), 0.02);
    pixel.lamps[1] = stock().lamp("F11");
    EXPECT_GT(error_of(Method::tristimulus, pixel), 1);
    Pixel glass = stock().pair("E", "cc-white");
    glass.medium = stock().layer("glass-cobalt");
    glass.thickness = 3;
    EXPECT_GT(error_of(Method::tristimulus, glass), 1);
}

double reduced_error(const Pixel& pixel, int count) {
    Sight sight = stock().sight();
    const Taps taps = taps_for(pixel, count);
    sight.taps = &taps;
    double worst = 0;
    for (int step = 0; step <= 9; ++step) { // not the steps that the taps were fitted to
        Pixel part = pixel;
        part.thickness = pixel.thickness * step / 9;
        for (PixelLamp& lamp : part.lamps)
            lamp.light = {1 - step / 10.0, 0.125, pixel.other ? step / 20.0 : 0};
        worst = std::max(worst, delta_e_2000(shade_xyz<double>(Method::reduced, part, sight),
                                             exact_xyz(part, stock().exact())));
    }
    return worst;
}

TEST(Reduced, FollowsMediaUnderLinesAndSmoothLamps) {
    for (const char* lamp : {"A2800", "D65", "F11", "krypton", "NIST-LPS"})
        for (const char* medium : {"glass-cobalt", "liquid-allura-red", "glass-neodymium"}) {
            Pixel pixel = stock().pair(lamp, "cc-white");
            pixel.medium = stock().layer(medium);
            pixel.thickness = 4;
            EXPECT_LT(reduced_error(pixel, 8), 0.5) << lamp << " through " << medium;
            // Between samples T^d is one guess of the taps' and another of the grid's: both hold the ends.
            EXPECT_LT(reduced_error(rows_only(pixel), 8), 2) << lamp << " through " << medium << ", rows";
        }
}

TEST(Reduced, FollowsLightFromAnotherWall) {
    for (const char* lamp : {"A2800", "F11", "NIST-LPS"}) {
        Pixel pixel = stock().pair(lamp, "crayon-red");
        pixel.other = stock().layer("crayon-blue");
        EXPECT_LT(reduced_error(pixel, 8), 0.5) << lamp;
    }
}

} // namespace
} // namespace metamer::test
