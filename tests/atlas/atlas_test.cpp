#include "atlas/atlas.h"

#include <gmock/gmock.h>

#include "atlas/atlas_check.h"
#include "atlas/samples.h"
#include "image/error_of.h"

namespace metamer {
namespace {

using ::testing::Each;

int red(const Atlas& atlas, int row, std::size_t i) {
    return atlas.rgba[atlas_byte(row, i, AtlasChannel::lamp)];
}
int green(const Atlas& atlas, int row, std::size_t i) {
    return atlas.rgba[atlas_byte(row, i, AtlasChannel::material)];
}
int blue(const Atlas& atlas, int row, std::size_t i) {
    return atlas.rgba[atlas_byte(row, i, AtlasChannel::excitation)];
}

TEST(Atlas, BytesGoByRowThenIntervalThenChannel) {
    EXPECT_EQ(atlas_byte(0, 0, AtlasChannel::lamp), 0u);
    EXPECT_EQ(atlas_byte(0, 1, AtlasChannel::material), 5u);
    EXPECT_EQ(atlas_byte(2, 3, AtlasChannel::alpha), 2u * 256 + 3 * 4 + 3);
}

// By hand from the 1931 table and its greatest value, z = 1.7826 at 445 nm. The thesis prints x = 151 for 595
// nm.
TEST(Atlas, Row0IsTheObserverRoundedHalfUp) {
    const Atlas atlas = empty_atlas(Quantization::thesis);
    EXPECT_EQ(red(atlas, 0, 42), 151);   // 595 nm: 1.0567 / 1.7826 * 255 = 151.16
    EXPECT_EQ(red(atlas, 0, 43), 152);   // 600 nm: 1.0622 / 1.7826 * 255 = 151.95
    EXPECT_EQ(green(atlas, 0, 34), 143); // 555 nm: 1.0000 / 1.7826 * 255 = 143.05
    EXPECT_EQ(blue(atlas, 0, 12), 255);  // 445 nm
    EXPECT_EQ(red(atlas, 0, 12), 50);    // 445 nm: 0.34828 / 1.7826 * 255 = 49.82
    EXPECT_EQ(green(atlas, 0, 12), 4);   // 445 nm: 0.02980 / 1.7826 * 255 = 4.26
    for (std::size_t i = 0; i < kIntervals; ++i)
        EXPECT_EQ(atlas.rgba[atlas_byte(0, i, AtlasChannel::alpha)], 255);
    EXPECT_EQ(flaw_of(atlas), std::nullopt);
}

TEST(Atlas, MaterialsAreRoundedHalfUp) {
    Atlas atlas = empty_atlas(Quantization::thesis);
    const double values[] = {0,     0.0019, 0.002, 0.4,
                             0.498, 0.5,    0.999, 1}; // * 255: 0.48, 0.51, 102, 126.99, 127.5 ..
    const int bytes[] = {0, 0, 1, 102, 127, 128, 255, 255};
    const int key = add_material(
        atlas, {"steps", "", "by hand", {curve_on_grid([&](std::size_t i) { return values[i % 8]; })}});
    EXPECT_EQ(key, 1);
    for (std::size_t i = 0; i < kIntervals; ++i) {
        EXPECT_EQ(green(atlas, 1, i), bytes[i % 8]) << i;
        EXPECT_EQ(red(atlas, 1, i), 0) << i;
        EXPECT_EQ(blue(atlas, 1, i), 0) << i;
    }
    EXPECT_EQ(atlas.materials[1].name, "steps");
    EXPECT_EQ(atlas.materials[1].source, "by hand");
    EXPECT_EQ(atlas.materials[1].scale, 1);
}

TEST(Atlas, LampsArePeak255AndKeepTheirPeak) {
    Atlas atlas = empty_atlas(Quantization::thesis);
    EXPECT_EQ(add_lamp(atlas, ramp_lamp("ramp", 12.6)), 1);
    EXPECT_EQ(red(atlas, 1, 0), 0);
    EXPECT_EQ(red(atlas, 1, 1), 4);    // 255 / 63 = 4.05
    EXPECT_EQ(red(atlas, 1, 21), 85);  // a third
    EXPECT_EQ(red(atlas, 1, 62), 251); // 250.95
    EXPECT_EQ(red(atlas, 1, 63), 255);
    EXPECT_EQ(green(atlas, 1, 63), 0);
    EXPECT_NEAR(atlas.lamps[1].peak, 12.6, 1e-12);
    EXPECT_EQ(atlas.lamps[1].name, "ramp");
    EXPECT_EQ(atlas.lamps[1].source, "a test");
}

// 589.3 nm: 0.7 nm below 590 nm, so 0.86 of the power goes there, 0.14 to 585 nm: 0.14 / 0.86 * 255 = 41.5.
TEST(Atlas, ALineIsSharedByTwoIntervals) {
    Atlas atlas = empty_atlas(Quantization::thesis);
    add_lamp(atlas, line_lamp("line", 589.3));
    EXPECT_EQ(red(atlas, 1, 41), 255);
    EXPECT_NEAR(red(atlas, 1, 40), 41.5, 0.51);
    EXPECT_EQ(red(atlas, 1, 39), 0);
    EXPECT_EQ(red(atlas, 1, 42), 0);
    EXPECT_NEAR(atlas.lamps[1].peak, 0.86 / 5, 1e-12); // power per nm
}

TEST(Atlas, LampsAndMaterialsFillRowsApart) {
    const Atlas atlas = sample_atlas();
    EXPECT_EQ(find_lamp_key(atlas, "ramp"), 1);
    EXPECT_EQ(find_lamp_key(atlas, "line:589.3"), 2);
    EXPECT_EQ(find_lamp_key(atlas, "Gl\xC3\xBChlampe"), 3);
    EXPECT_EQ(find_material_key(atlas, "gray"), 1);
    EXPECT_EQ(find_material_key(atlas, "black"), 2);
    EXPECT_EQ(flaw_of(atlas), std::nullopt);
}

TEST(Atlas, FindsNamesWithoutCaseThenKeys) {
    Atlas atlas = sample_atlas();
    EXPECT_EQ(find_lamp_key(atlas, " RAMP "), 1);
    EXPECT_EQ(find_lamp_key(atlas, "3"), 3);
    EXPECT_EQ(find_lamp_key(atlas, "gray"), 0);
    EXPECT_EQ(find_material_key(atlas, "ramp"), 0);
    for (const char* none : {"", "0", "4", "64", "-1", "1.0", "99999999999"})
        EXPECT_EQ(find_lamp_key(atlas, none), 0) << none;
    EXPECT_EQ(add_material(atlas, flat_material("1", 1)), 3); // a name goes before a key
    EXPECT_EQ(find_material_key(atlas, "1"), 3);
    EXPECT_EQ(find_material_key(atlas, "2"), 2);
}

TEST(Atlas, AddsANameOnce) {
    Atlas atlas = sample_atlas();
    const Atlas before = atlas;
    EXPECT_EQ(add_lamp(atlas, ramp_lamp("Ramp", 12.3)), 1);
    EXPECT_EQ(add_material(atlas, flat_material("GRAY", 0.501)), 1); // 127.76: the same bytes
    EXPECT_EQ(atlas.rgba, before.rgba);
    EXPECT_EQ(atlas.lamps[1].name, "ramp");
    EXPECT_TRUE(atlas.lamps[4].name.empty());
}

TEST(Atlas, RefusesTwoSpectraOfOneName) {
    Atlas atlas = sample_atlas();
    const Atlas before = atlas;
    EXPECT_EQ(error_of([&] { add_lamp(atlas, line_lamp("Ramp", 500)); }),
              "2: cannot add lamp \"Ramp\": the atlas holds another spectrum of this name in row 1");
    EXPECT_EQ(error_of([&] { add_material(atlas, flat_material("black", 1)); }),
              "2: cannot add material \"black\": the atlas holds another spectrum of this name in row 2");
    EXPECT_EQ(atlas.rgba, before.rgba);
}

TEST(Atlas, RefusesThe64thRow) {
    Atlas atlas = empty_atlas(Quantization::thesis);
    for (int n = 1; n <= 63; ++n) {
        EXPECT_EQ(add_lamp(atlas, line_lamp("lamp " + std::to_string(n), 420 + 4 * n)), n);
        EXPECT_EQ(add_material(atlas, flat_material("material " + std::to_string(n), n / 63.0)), n);
    }
    EXPECT_EQ(flaw_of(atlas), std::nullopt);
    EXPECT_EQ(error_of([&] { add_lamp(atlas, line_lamp("lamp 64", 500)); }),
              "2: cannot add lamp \"lamp 64\": all 63 lamp rows of the atlas are taken");
    EXPECT_EQ(error_of([&] { add_material(atlas, flat_material("material 64", 1)); }),
              "2: cannot add material \"material 64\": all 63 material rows of the atlas are taken");
    EXPECT_EQ(add_lamp(atlas, line_lamp("LAMP 63", 672)), 63);
}

TEST(Atlas, RefusesALampWithoutLightOnTheGrid) {
    Atlas atlas = empty_atlas(Quantization::thesis);
    EXPECT_EQ(error_of([&] { add_lamp(atlas, line_lamp("infrared", 1000)); }),
              "2: cannot add lamp \"infrared\": it has no light on the atlas's grid, 385 .. 700 nm");
    EXPECT_EQ(atlas.rgba, empty_atlas(Quantization::thesis).rgba);
}

// Mercury's violet line: 8 bits round the observer's y to 0 there, and nothing can be divided by k' = 0.
TEST(Atlas, RefusesALampThatItsObserverDoesNotSee) {
    Atlas atlas = empty_atlas(Quantization::thesis);
    for (double violet_nm : {385.0, 404.7, 415.0})
        EXPECT_EQ(error_of([&] { add_lamp(atlas, line_lamp("violet", violet_nm)); }),
                  "2: cannot add lamp \"violet\": all of its light lies where the atlas's 8-bit observer has "
                  "y = 0, so "
                  "that k' = 0");
    EXPECT_EQ(add_lamp(atlas, line_lamp("blue", 420)), 1);
    atlas.rgba[atlas_byte(1, 7, AtlasChannel::lamp)] = 0; // 420 nm
    atlas.rgba[atlas_byte(1, 3, AtlasChannel::lamp)] = 255;
    EXPECT_EQ(flaw_of(atlas), "row 1: lamp \"blue\" has light only where the observer's y is 0");
}

TEST(Atlas, RefusesNamesThatCannotBeWritten) {
    Atlas atlas = empty_atlas(Quantization::thesis);
    const auto refused = [&](const std::string& name, const std::string& source) {
        return error_of([&] { add_material(atlas, {name, "", source, flat_material("", 1).spectrum}); });
    };
    EXPECT_EQ(refused("", "x"), "2: cannot add material \"\": the name is empty");
    EXPECT_EQ(refused(" a", "x"), "2: cannot add material \" a\": the name begins or ends with a blank");
    EXPECT_EQ(refused("a\tb", "x"),
              "2: cannot add material \"a?b\": the name or its source holds a control character");
    EXPECT_EQ(refused("a", "x\ny"),
              "2: cannot add material \"a\": the name or its source holds a control character");
    EXPECT_EQ(refused("caf\xE9", "x"),
              "2: cannot add material \"caf?\": the name or its source is not UTF-8");
    EXPECT_EQ(atlas.rgba, empty_atlas(Quantization::thesis).rgba);
}

TEST(Atlas, ReadsBackWhatTheShaderSees) {
    Atlas atlas = sample_atlas();
    EXPECT_DOUBLE_EQ(emission(atlas, 1).value[21], 85 / 255.0);
    EXPECT_DOUBLE_EQ(emission(atlas, 1).value[63], 1);
    EXPECT_THAT(reflectance(atlas, 1).value, Each(128 / 255.0));
    EXPECT_THAT(reflectance(atlas, 2).value, Each(0));
    atlas.materials[1].scale = 0.25;
    EXPECT_THAT(reflectance(atlas, 1).value, Each(128 / 255.0 * 0.25));
    const GridObserver row0 = observer(atlas);
    EXPECT_DOUBLE_EQ(row0.x[42], 151 / 255.0);
    EXPECT_DOUBLE_EQ(row0.y[34], 143 / 255.0);
    EXPECT_DOUBLE_EQ(row0.z[12], 1);
    const GridObserver exact = sampled_observer();
    for (std::size_t i = 0; i < kIntervals; ++i)
        EXPECT_LE(std::abs(row0.x[i] - exact.x[i]), 0.5 / 255 + 1e-12) << i;
}

} // namespace
} // namespace metamer
