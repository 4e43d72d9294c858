#include "methods/folded.h"

#include <gtest/gtest.h>

#include "color/difference.h"
#include "methods/stock.h"

namespace metamer::test {
namespace {

void expect_equal(const Xyz& a, const Xyz& b, const std::string& what, double rounding = 1e-12) {
    EXPECT_NEAR(a.x, b.x, rounding) << what;
    EXPECT_NEAR(a.y, b.y, rounding) << what;
    EXPECT_NEAR(a.z, b.z, rounding) << what;
}

Pixel three_lamps(const std::string& material) {
    Pixel pixel = stock().pair("F11", material, 2);
    pixel.lamps[0].light = {0.5, 0.25, 0.125};
    pixel.lamps.push_back(stock().lamp("A2800", 0.5, {0.25, 0, 0.5}));
    pixel.lamps.push_back(stock().lamp("krypton", 1, {0, 0.5, 0.25}));
    return pixel;
}

// Whatever the light: that is what makes it a constant.
TEST(Folded, IsExactWhereLightIsLinear) {
    for (const char* material : {"cc-red", "crayon-black", "cc-cyan"})
        for (const bool walls : {false, true}) {
            Pixel pixel = three_lamps(material);
            if (walls)
                pixel.other = stock().layer("crayon-blue");
            for (const Pixel& known : {pixel, rows_only(pixel)})
                expect_equal(shade_xyz<double>(Method::folded, known, stock().sight()),
                             exact_xyz(known, stock().exact()), material);
        }
}

// Equations 7.1, 7.6-7.10 at 1 nm, by the function of another room.
TEST(Folded, IsTheReferenceForAPair) {
    for (const char* lamp : {"D65", "F11", "NIST-LPS"})
        expect_equal(shade_xyz<double>(Method::folded, stock().pair(lamp, "cc-orange"), stock().sight()),
                     reference_xyz(find_lamp(lamp).spectrum, find_material("cc-orange").spectrum), lamp);
}

TEST(ReflectedColors, AreEachLampAloneOnTheMaterialWhateverTheLight) {
    const Pixel pixel = three_lamps("cc-orange");
    const auto colors = reflected_colors(pixel, stock().exact(), Matrix3::identity());
    ASSERT_EQ(colors.size(), 3u);
    for (std::size_t l = 0; l < 3; ++l) {
        const ReferenceLamp& lamp = *pixel.lamps[l].full;
        expect_equal({colors[l][0], colors[l][1], colors[l][2]},
                     pixel.lamps[l].strength * reference_xyz(lamp, *pixel.material.full), std::to_string(l));
    }
}

TEST(Folded, MixedReflectancesAreMixedColors) {
    const Pixel a = stock().pair("F11", "cc-red"), b = stock().pair("F11", "cc-blue");
    std::vector<double> mixed = *a.material.full;
    for (std::size_t i = 0; i < mixed.size(); ++i)
        mixed[i] = 0.25 * mixed[i] + 0.75 * (*b.material.full)[i];
    Pixel c = a;
    c.material.full = &mixed;
    const Sight sight = stock().sight();
    expect_equal(shade_xyz<double>(Method::folded, c, sight),
                 0.25 * shade_xyz<double>(Method::folded, a, sight) +
                     0.75 * shade_xyz<double>(Method::folded, b, sight),
                 "a quarter red");
}

TEST(Packed, IsSpectralInDouble) {
    Pixel pixel = rows_only(three_lamps("cc-orange"));
    const Sight sight = stock().sight();
    const auto both = [&](const std::string& what) {
        expect_equal(shade_xyz<double>(Method::packed, pixel, sight),
                     shade_xyz<double>(Method::spectral, pixel, sight), what);
    };
    both("plain");
    pixel.other = stock().layer("crayon-blue");
    both("by another wall");
    pixel.other.reset();
    pixel.medium = stock().layer("glass-cobalt");
    pixel.thickness = 2.5;
    both("through glass");
}

TEST(Spectral, IsExactOnTheAtlasButForTheObserversEightBits) {
    const Pixel pixel = rows_only(three_lamps("cc-orange"));
    Sight sight = stock().sight();
    EXPECT_LT(
        delta_e_2000(shade_xyz<double>(Method::spectral, pixel, sight), exact_xyz(pixel, stock().exact())),
        0.3);
    sight.seen = sight.exact;
    expect_equal(shade_xyz<double>(Method::spectral, pixel, sight), exact_xyz(pixel, stock().exact()), "");
}

} // namespace
} // namespace metamer::test
