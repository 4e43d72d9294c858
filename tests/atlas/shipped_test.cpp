// The shipped atlases are what the library makes today; scripts/build-atlases writes them.
#include <cmath>
#include <gtest/gtest.h>

#include "atlas/atlas_file.h"
#include "spectra/library.h"

namespace metamer {
namespace {

// The texels are the same everywhere. Numbers beside them are sums of exp() and pow(), whose last digits are
// the C library's own: with fused multiply-adds on x86, without on Arm.
void expect_same(double shipped, double built) {
    EXPECT_NEAR(shipped, built, 1e-12 * std::abs(shipped));
}

void expect_shipped(const std::string& file, const MaterialSet& set, Quantization quantization) {
    Atlas built = empty_atlas(quantization);
    for (const Lamp& lamp : library_lamps())
        add_lamp(built, lamp);
    for (const std::string& name : set.materials)
        add_material(built, find_material(name), library_lamps());
    const Atlas shipped = read_atlas(METAMER_SOURCE_DIR "/atlas/" + file);
    EXPECT_EQ(shipped.quantization, quantization);
    EXPECT_EQ(shipped.rgba, built.rgba);
    for (std::size_t key = 1; key < kAtlasSize; ++key) {
        EXPECT_EQ(shipped.lamps[key].name, built.lamps[key].name);
        EXPECT_EQ(shipped.lamps[key].source, built.lamps[key].source);
        expect_same(shipped.lamps[key].peak, built.lamps[key].peak);
        EXPECT_EQ(shipped.materials[key].name, built.materials[key].name);
        EXPECT_EQ(shipped.materials[key].source, built.materials[key].source);
        expect_same(shipped.materials[key].scale, built.materials[key].scale);
    }
}

class ShippedAtlas : public testing::TestWithParam<MaterialSet> {};

TEST_P(ShippedAtlas, HoldsTheLibrarysLampsAndItsSet) {
    expect_shipped(GetParam().name + ".png", GetParam(), Quantization::weighted);
}

INSTANTIATE_TEST_SUITE_P(Sets, ShippedAtlas,
                         testing::ValuesIn(material_sets().begin(), material_sets().end()),
                         [](const auto& set) { return set.param.name; });

TEST(ShippedThesisAtlas, HoldsTheLibrarysLampsAndTheCrayons) {
    expect_shipped("crayons-thesis.png", *find_material_set("crayons"), Quantization::thesis);
}

} // namespace
} // namespace metamer
