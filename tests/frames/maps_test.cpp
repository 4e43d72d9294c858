// Objects with maps, and ramps: each pixel's material by hand.
#include <cmath>
#include <gtest/gtest.h>
#include <stdexcept>

#include "frames/frames.h"
#include "plan/twin.h"
#include "render/surface_maps.h"
#include "render/tables.h"
#include "render/variants.h"

namespace metamer {
namespace {

/// The still life with its wall lit straight on, so that a pixel of it is the pair's color.
Exhibit wall_by(const std::string& method) {
    return exhibit_of(
        "[display]\nwidth = 160\nheight = 90\n[accuracy]\nmethod = " + method +
        "\n[scene]\nkind = still-life\nmaterials = cc-red, cc-cyan, cc-yellow\n[lamp.1]\nspectrum = "
        "F2\ndirection = 0 0 -1\n[object.wall]\nspecular = 0\n");
}

ObjectSetting& wall(Exhibit& exhibit) {
    return object_of(exhibit, "wall");
}

/// What the wall shows where it is of this material; a luminance map scales its light as a cosine does.
EncodedRgb8 twin(Exhibit& exhibit, int key, double luminance = 1, double cosine = 1) {
    const Twin twin(exhibit);
    Pixel pixel = twin.pixel_on(wall(exhibit));
    pixel.material = twin.spectra().material(key);
    for (PixelLamp& lamp : pixel.lamps)
        lamp.light.diffuse = luminance * cosine;
    return twin.rgb8(wall(exhibit), pixel);
}

Image two_texels(std::uint8_t left, std::uint8_t right) {
    return {2, 1, {left, left, left, 255, right, right, right, 255}};
}

// The wall fills the frame's upper corners; its left half shows the map's left texel.
constexpr int kLeftX = 15, kRightX = 144, kTopY = 8;

class MapsBy : public testing::TestWithParam<MethodInfo> {};

TEST_P(MapsBy, KeysNameMaterials) {
    Exhibit exhibit = wall_by(std::string(GetParam().name));
    wall(exhibit).key_map = two_texels(1, 2);
    const Image image = frame_of(exhibit);
    EXPECT_LE(steps(pixel(image, kLeftX, kTopY), twin(exhibit, 1)), 1);
    EXPECT_LE(steps(pixel(image, kRightX, kTopY), twin(exhibit, 2)), 1);
    EXPECT_GT(steps(twin(exhibit, 1), twin(exhibit, 2)), 40) << "the keys tell materials apart";
}

TEST_P(MapsBy, ThePicturesTopIsTheTop) {
    // The frame shows the wall's lower half: the third and the fourth of four rows.
    Exhibit exhibit = wall_by(std::string(GetParam().name));
    wall(exhibit).key_map = Image{1, 4, {3, 0, 0, 255, 3, 0, 0, 255, 1, 0, 0, 255, 2, 0, 0, 255}};
    const Image image = frame_of(exhibit);
    EXPECT_LE(steps(pixel(image, 3, kTopY), twin(exhibit, 1)), 1);
    EXPECT_LE(steps(pixel(image, 3, 38), twin(exhibit, 2)), 1);
}

TEST_P(MapsBy, WhatHasNoKeyMapKeepsItsMaterial) {
    Exhibit exhibit = wall_by(std::string(GetParam().name));
    wall(exhibit).material.key = 2;
    wall(exhibit).luminance_map = Image{1, 1, {255, 0, 0, 255}};
    EXPECT_LE(steps(pixel(frame_of(exhibit), kLeftX, kTopY), twin(exhibit, 2)), 1);
}

/// Heights that rise by one over the map's width, to the right or upwards.
Image slope(bool upwards) {
    Image image{8, 8, {}};
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x)
            image.rgba.insert(image.rgba.end(),
                              {static_cast<std::uint8_t>((upwards ? 7 - y : x) * 255 / 8), 0, 0, 255});
    return image;
}

TEST_P(MapsBy, ASlopeIsLitAsItIsTilted) {
    const double height = 0.4;
    for (bool upwards : {false, true}) {
        Exhibit exhibit = wall_by(std::string(GetParam().name));
        exhibit.lamps[0].direction = {-0.6, -0.48, -0.64}; // from the right, from above, from the front
        wall(exhibit).bump_map = slope(upwards);
        wall(exhibit).bump = height;
        // Uphill to the right looks left, (-height, 0, 1); uphill looks down.
        const double cosine = (0.64 - height * (upwards ? 0.48 : 0.6)) / std::hypot(1, height);
        EXPECT_LE(steps(pixel(frame_of(exhibit), kLeftX, kTopY),
                        twin(exhibit, wall(exhibit).material.key, 1, cosine)),
                  2)
            << upwards;
    }
}

// Between a level texel and a steep one the normal passes the lamp's direction, at its full length.
TEST_P(MapsBy, NormalsBetweenTexelsAreOfUnitLength) {
    Exhibit exhibit = wall_by(std::string(GetParam().name));
    Image& heights = wall(exhibit).bump_map.emplace(Image{4, 1, {}});
    for (const int height : {0, 128, 255, 128})
        heights.rgba.insert(heights.rgba.end(), {static_cast<std::uint8_t>(height), 0, 0, 255});
    wall(exhibit).bump = 1; // slopes of 0, 2, 0, -2
    const double half_way = std::atan(2.0) / 2;
    exhibit.lamps[0].direction = {static_cast<float>(std::sin(half_way)), 0,
                                  -static_cast<float>(std::cos(half_way))};
    const Image image = frame_of(exhibit);
    int brightest = 0;
    for (int x = 0; x < 160; ++x)
        brightest = std::max<int>(brightest, pixel(image, x, kTopY).r);
    EXPECT_NEAR(brightest, twin(exhibit, wall(exhibit).material.key).r, 2);
}

// A key is a name: between 1 and 3 lies no 2.
TEST_P(MapsBy, KeysAreNotMixed) {
    Exhibit exhibit = wall_by(std::string(GetParam().name));
    wall(exhibit).key_map = two_texels(1, 3);
    const Image image = frame_of(exhibit);
    const EncodedRgb8 one = twin(exhibit, 1), three = twin(exhibit, 3);
    for (int x = 0; x < 160; ++x)
        EXPECT_LE(std::min(steps(pixel(image, x, kTopY), one), steps(pixel(image, x, kTopY), three)), 1) << x;
}

TEST_P(MapsBy, LuminanceScalesReflectance) {
    Exhibit exhibit = wall_by(std::string(GetParam().name));
    wall(exhibit).luminance_map = Image{1, 1, {128, 128, 128, 255}};
    const int key = wall(exhibit).material.key;
    EXPECT_LE(steps(pixel(frame_of(exhibit), kLeftX, kTopY), twin(exhibit, key, 128.0 / 255)), 1);
}

TEST_P(MapsBy, AFlatBumpMapChangesNothing) {
    Exhibit exhibit = wall_by(std::string(GetParam().name));
    exhibit.lamps[0].direction = {-1, 0, -0.02}; // so low that a hundredth of tilt would show
    exhibit.lamps[0].strength = 20;
    const Image plain = frame_of(exhibit);
    EXPECT_GT(pixel(plain, kLeftX, kTopY).r, 40);
    wall(exhibit).bump_map = two_texels(77, 77);
    wall(exhibit).bump = 0.5;
    const Image bumped = frame_of(exhibit);
    EXPECT_LE(steps(pixel(plain, kLeftX, kTopY), pixel(bumped, kLeftX, kTopY)), 1);
}

INSTANTIATE_TEST_SUITE_P(Methods, MapsBy, testing::ValuesIn(kMethods),
                         [](const auto& method) { return std::string(method.param.name); });

TEST(Bump, ASlopeTiltsTheNormal) {
    // Heights that rise by one map width over one map width: 45 degrees.
    Image slope{8, 1, {}};
    for (int x = 0; x < 8; ++x)
        slope.rgba.insert(slope.rgba.end(), {static_cast<std::uint8_t>(x * 255 / 8), 0, 0, 255});
    const Image normals = normal_map(slope, 1);
    const double tilt = (normals.rgba[4 * 3] - 128) / 127.0, up = (normals.rgba[4 * 3 + 2] - 128) / 127.0;
    EXPECT_NEAR(tilt, -std::sqrt(0.5), 0.03) << "uphill to the right looks left";
    EXPECT_NEAR(up, std::sqrt(0.5), 0.03);
    EXPECT_EQ(normals.rgba[4 * 3 + 1], 128) << "level the other way";
    // Maps repeat: the first column's left neighbor is the last.
    EXPECT_NEAR((normals.rgba[0] - 128) / 127.0, 3 / std::sqrt(10.0), 0.02);
}

TEST(Bump, UphillLooksDown) {
    Image heights{1, 4, {}};
    for (const int height : {255, 170, 85, 0})
        heights.rgba.insert(heights.rgba.end(), {static_cast<std::uint8_t>(height), 0, 0, 255});
    const Image normals = normal_map(heights, 3);
    // A third up over one texel, which is as wide as the map: 45 degrees at a height of 3.
    EXPECT_EQ(normals.rgba[4], 128);
    EXPECT_NEAR((normals.rgba[5] - 128) / 127.0, -std::sqrt(0.5), 0.005);
    EXPECT_NEAR((normals.rgba[6] - 128) / 127.0, std::sqrt(0.5), 0.005);
}

TEST(ProductTable, HoldsNumbersToASixteenBitStep) {
    const Exhibit exhibit = wall_by("rgb");
    const HalfView view = half_views(exhibit).front();
    const Image map = product_table(Method::rgb, ExhibitSpectra(exhibit), view.output);
    for (int key = 1; key <= 3; ++key) {
        const auto numbers = material_numbers(Method::rgb, reflectance(exhibit.atlas, key),
                                              observer(exhibit.atlas), view.output);
        for (std::size_t c = 0; c < 3; ++c) {
            const std::uint8_t* row = &map.rgba[static_cast<std::size_t>(key) * 8];
            const double read = (row[c] * 256 + row[4 + c]) / 65535.0 * kMaterialMapSpan + kMaterialMapLeast;
            EXPECT_NEAR(read, numbers[c], kMaterialMapSpan / 65535);
        }
    }
}

TEST(ProductTable, ClampsWhatItsCodesCannotHold) {
    const Exhibit exhibit = wall_by("rgb");
    OutputSpace output = half_views(exhibit).front().output;
    output.rgb_from_xyz = Matrix3::diagonal(1000, -1000, 0.5);
    const Image map = product_table(Method::rgb, ExhibitSpectra(exhibit), output);
    const std::uint8_t* row = &map.rgba[8]; // key 1
    EXPECT_EQ(row[0], 255);
    EXPECT_EQ(row[4], 255);
    EXPECT_EQ(row[1], 0);
    EXPECT_EQ(row[5], 0);
}

/// Two materials mixed as the ramp of reflectances mixes them.
struct Mixed {
    Mixed(const Layer& a, const Layer& b, double t) : full(full_values(a)) {
        for (std::size_t i = 0; i < kIntervals; ++i)
            row.value[i] = (1 - t) * a.row->value[i] + t * b.row->value[i];
        const std::vector<double> end = full_values(b);
        for (std::size_t i = 0; i < full.size(); ++i)
            full[i] = (1 - t) * full[i] + t * end[i];
    }
    Layer layer(bool at_full_resolution) const { return {&row, at_full_resolution ? &full : nullptr}; }

    Reflectance row;
    std::vector<double> full;
};

/// The third bar: code values are mixed, as a paint program does.
EncodedRgb8 mixed_codes(const Twin& twin, const ObjectSetting& ramp, double t) {
    const OutputSpace& output = twin.view().output;
    const auto numbers = [&](const MaterialSetting& material) {
        return material_numbers(Method::rgb, *twin.spectra().material(material.key).row,
                                twin.spectra().seen(), output);
    };
    const auto begin = numbers(ramp.material), end = numbers(*ramp.material_end);
    const HalfLamp& lamp = twin.view().lamps[0];
    const auto of_lamp = lamp_numbers(Method::rgb, lamp.emission, twin.spectra().seen(), output);
    std::array<double, 3> c{};
    for (std::size_t k = 0; k < 3; ++k)
        c[k] = lamp.strength * of_lamp[k] *
               decode(output.transfer,
                      (1 - t) * encode(output.transfer, begin[k]) + t * encode(output.transfer, end[k]));
    return encode_rgb8(output.transfer, LinearRgb{c[0], c[1], c[2]});
}

void compare_ramp(const std::string& materials, double strength, const std::vector<int>& columns,
                  Transfer transfer = Transfer::srgb) {
    Exhibit exhibit =
        exhibit_of("[display]\nwidth = 256\nheight = 96\n[scene]\nkind = ramp\nmaterials = " + materials +
                   "\n[lamp.1]\nspectrum = F11\n");
    exhibit.lamps[0].strength = strength;
    exhibit.display.transfer = transfer;
    for (const MethodInfo& info : kMethods) {
        if (info.method != Method::rgb) // which mixes code values whatever the bar
            exhibit.objects[0].method = info.method;
        const Image image = frame_of(exhibit);
        const Twin twin(exhibit);
        const Layer a = twin.spectra().material(exhibit.objects[0].material.key);
        const Layer b = twin.spectra().material(exhibit.objects[0].material_end->key);
        for (int x : columns) {
            const double t = (x + 0.5) / 256;
            const Mixed mixed(a, b, t);
            for (int bar = 0; bar < 2; ++bar) {
                const ObjectSetting& ramp = exhibit.objects[static_cast<std::size_t>(bar)];
                Pixel seen = twin.pixel_on(ramp);
                seen.material = mixed.layer(a.full && b.full);
                EXPECT_LE(steps(pixel(image, x, bar * 32 + 16), twin.rgb8(ramp, seen)), 1)
                    << info.name << ' ' << x << ' ' << bar;
            }
            EXPECT_LE(steps(pixel(image, x, 80), mixed_codes(twin, exhibit.objects[2], t)), 1) << x;
        }
    }
}

TEST(Ramp, MixesByReflectanceByXyzAndByCodes) {
    compare_ramp("cc-blue, cc-yellow", 0.8, {2, 64, 128, 200, 253});
}

TEST(Ramp, WithoutACurveCodesAreLight) {
    compare_ramp("cc-blue, cc-yellow", 0.8, {2, 64, 128, 200, 253}, Transfer::none);
}

// Black to white passes the curve's straight part, codes up to 10; a strong lamp shows it.
TEST(Ramp, KnowsTheCurvesStraightPart) {
    compare_ramp("rgb:000000, cc-white", 20, {1, 3, 5, 7, 9, 11});
}

} // namespace
} // namespace metamer
