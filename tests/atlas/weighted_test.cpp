// Rows of Quantization::weighted.
#include <cmath>

#include <gmock/gmock.h>

#include "atlas/atlas_check.h"
#include "atlas/row_levels.h"
#include "atlas/samples.h"
#include "base/error.h"
#include "color/colorimetry.h"
#include "color/difference.h"
#include "image/error_of.h"

namespace metamer {
namespace {

using ::testing::Each;

TEST(Weighted, Row0KeepsTheSumsOfNeighbors) {
    const Atlas atlas = empty_atlas();
    EXPECT_EQ(atlas.quantization, Quantization::weighted);
    const GridObserver exact = exact_observer(atlas), row0 = observer(atlas);
    double x = 0, y = 0, z = 0;
    for (std::size_t i = 0; i < kIntervals; ++i) {
        x += row0.x[i] - exact.x[i];
        y += row0.y[i] - exact.y[i];
        z += row0.z[i] - exact.z[i];
        EXPECT_LE(std::max({std::abs(x), std::abs(y), std::abs(z)}), 0.5 / 255 + 1e-12) << i;
    }
    EXPECT_EQ(row0.z[12], 1);
    EXPECT_EQ(flaw_of(atlas), std::nullopt);
}

TEST(Weighted, TheExactObserverIsTheQuantizations) {
    EXPECT_EQ(exact_observer(empty_atlas(Quantization::thesis)).x, sampled_observer().x);
    EXPECT_EQ(exact_observer(empty_atlas(Quantization::weighted)).x, weighted_observer().x);
}

TEST(Weighted, EqualEnergyAndWhiteStayFlat) {
    Atlas atlas = empty_atlas();
    add_lamp(atlas, {"E", "", "", {{{300, 900}, {2, 2}}, {}}});
    add_material(atlas, {"white", "", "", {{{300, 900}, {1, 1}}}});
    EXPECT_THAT(atlas_row(atlas, 1, AtlasChannel::lamp), Each(255));
    EXPECT_THAT(atlas_row(atlas, 1, AtlasChannel::material), Each(255));
    EXPECT_EQ(atlas.materials[1].scale, 1);
    EXPECT_NEAR(atlas.lamps[1].peak, 2, 1e-6);
}

// Light beyond the grid's ends is not lost: it counts for the ends.
TEST(Weighted, LightOutsideTheGridIsFolded) {
    Atlas atlas = empty_atlas();
    const int inside = add_lamp(atlas, {"inside", "", "", {{{380, 700}, {1, 1}}, {}}});
    const int tail = add_lamp(atlas, {"with tail", "", "", {{{380, 700, 705, 830}, {1, 1, 4, 4}}, {}}});
    EXPECT_GT(emission(atlas, tail).value[63], 1.2 * emission(atlas, inside).value[63]);
    const int far_red = add_lamp(atlas, line_lamp("line:750", 750));
    EXPECT_EQ(emission(atlas, far_red).value[63], 1);
    EXPECT_EQ(emission(atlas, far_red).value[61], 0);
}

TEST(Weighted, OnlyALampThatNobodySeesIsRefused) {
    Atlas atlas = empty_atlas();
    const Atlas before = atlas;
    EXPECT_EQ(error_of([&] { add_lamp(atlas, line_lamp("infrared", 1000)); }),
              "2: cannot add lamp \"infrared\": it has no light that the eye sees, 360 .. 830 nm");
    EXPECT_EQ(error_of([&] {
                  add_lamp(atlas, {"dark", "", "", {{{380, 780}, {0, 0}}, {}}});
              }),
              "2: cannot add lamp \"dark\": it has no light that the eye sees, 360 .. 830 nm");
    EXPECT_EQ(atlas.rgba, before.rgba);
    for (const double violet_nm : {360.0, 385.0, 404.7, 415.0}) {
        const int key = add_lamp(atlas, line_lamp("line " + std::to_string(violet_nm), violet_nm));
        double k = 0;
        for (std::size_t i = 0; i < kIntervals; ++i)
            k += emission(atlas, key).value[i] * exact_observer(atlas).y[i];
        EXPECT_GT(k, 0) << violet_nm;
    }
    EXPECT_EQ(flaw_of(atlas), std::nullopt);
}

TEST(Weighted, MaterialsAreAtFullScale) {
    Atlas atlas = empty_atlas();
    for (const double level : {1e-5, 0.01, 0.3, 1.0}) {
        const int key = add_material(atlas, flat_material(std::to_string(level), level));
        EXPECT_GE(atlas_row(atlas, key, AtlasChannel::material)[30], 230) << level;
        const Reflectance there = reflectance(atlas, key);
        for (std::size_t i = 0; i < kIntervals; ++i)
            EXPECT_NEAR(there.value[i] / level, 1, 0.003) << level;
    }
    const int black = add_material(atlas, flat_material("black", 0));
    EXPECT_THAT(reflectance(atlas, black).value, Each(0));
    EXPECT_EQ(atlas.materials[static_cast<std::size_t>(black)].scale, 1);
}

// Found by the fuzzer: 255 / 1e-306 is no number any more.
TEST(MaterialLevels, OfNextToNothingAreBlack) {
    std::array<double, kIntervals> nothing;
    nothing.fill(1e-306);
    const MaterialLevels levels = material_levels({curve_of(nothing)});
    EXPECT_EQ(levels.scale, 1);
    for (const std::uint8_t level : levels.level)
        EXPECT_EQ(level, 0);
}

TEST(Weighted, TheScaleHasHeadroomForTheDark) {
    const auto valley = [](std::size_t i) { return i < 32 ? 0.8 : 0.01; };
    const MaterialLevels levels = material_levels({curve_on_grid(valley)});
    const double at_peak = levels.level[16] * levels.scale / 255;
    EXPECT_NEAR(at_peak, 0.8, 0.01);
    EXPECT_GE(levels.scale, 0.79);
    EXPECT_LE(levels.scale, 0.9);
}

// No light is made up far from a lamp's own, however well it would balance a sum.
TEST(Weighted, ALampIsDarkWhereItHasNoLight) {
    for (const double wavelength_nm : {390.0, 450.0, 589.3, 700.0}) {
        Atlas atlas = empty_atlas();
        add_lamp(atlas, line_lamp("line", wavelength_nm));
        for (std::size_t i = 0; i < kIntervals; ++i) {
            const bool far = std::abs(kThesisGrid.wavelength_nm(i) - wavelength_nm) > 10;
            EXPECT_TRUE(!far || emission(atlas, 1).value[i] == 0) << wavelength_nm << " at interval " << i;
        }
    }
}

TEST(Weighted, LampsArePeak255AndKeepTheirPeak) {
    Atlas atlas = empty_atlas();
    const int key = add_lamp(atlas, ramp_lamp("ramp", 12.6));
    const AtlasRow row = atlas_row(atlas, key, AtlasChannel::lamp);
    EXPECT_EQ(*std::max_element(row.begin(), row.end()), 255);
    const double power = emission(atlas, key).value[21] * atlas.lamps[1].peak;
    EXPECT_NEAR(power, 12.6 / 3, 2 * 12.6 / 255);
    Atlas tenfold = empty_atlas();
    add_lamp(tenfold, ramp_lamp("ramp", 126));
    EXPECT_EQ(atlas_row(tenfold, 1, AtlasChannel::lamp), row);
    EXPECT_NEAR(tenfold.lamps[1].peak / atlas.lamps[1].peak, 10, 1e-9);
}

TEST(Weighted, IsDeterministic) {
    const Atlas a = sample_atlas(Quantization::weighted), b = sample_atlas(Quantization::weighted);
    EXPECT_EQ(a.rgba, b.rgba);
    EXPECT_EQ(a.materials[1].scale, b.materials[1].scale);
    EXPECT_EQ(a.lamps[1].peak, b.lamps[1].peak);
}

TEST(Weighted, ANameIsOneSpectrum) {
    Atlas atlas = sample_atlas(Quantization::weighted);
    EXPECT_EQ(add_lamp(atlas, ramp_lamp("RAMP", 12.3)), 1);
    EXPECT_EQ(add_material(atlas, flat_material("gray", 0.5)), 1);
    // The same levels at another scale are another spectrum.
    EXPECT_EQ(error_of([&] { add_material(atlas, flat_material("gray", 0.25)); }),
              "2: cannot add material \"gray\": the atlas holds another spectrum of this name in row 1");
}

TEST(Quantization, IsFoundByName) {
    EXPECT_EQ(find_quantization("thesis"), Quantization::thesis);
    EXPECT_EQ(find_quantization("weighted"), Quantization::weighted);
    EXPECT_EQ(find_quantization("Thesis"), std::nullopt);
    EXPECT_EQ(name_of(Quantization::weighted), "weighted");
}

} // namespace
} // namespace metamer
