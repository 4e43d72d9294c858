// The CPU twins in double, float and half, pair by pair.
#include <algorithm>
#include <cstdlib>
#include <gtest/gtest.h>

#include "atlas/atlas.h"
#include "methods/pair.h"
#include "methods/three_numbers.h"

namespace metamer {
namespace {

int steps(const EncodedRgb8& a, const EncodedRgb8& b) {
    return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

struct Worst {
    int float_steps = 0, half_steps = 0;
};

Worst worst_of(Method method) {
    OutputSpace output;
    output.rgb_from_xyz = rgb_from_xyz(working_spaces()[0]);
    output.white = &white_emission(working_spaces()[0]);
    Atlas atlas = empty_atlas();
    for (const Lamp& lamp : library_lamps())
        add_lamp(atlas, lamp);
    for (const std::string& name : find_material_set("colorchecker")->materials)
        add_material(atlas, find_material(name));
    for (const std::string& name : find_material_set("crayons")->materials)
        add_material(atlas, find_material(name));
    const GridObserver seen_by = observer(atlas);
    Worst worst;
    for (int l = 1; !atlas.lamps[static_cast<std::size_t>(l)].name.empty(); ++l)
        for (int m = 1; !atlas.materials[static_cast<std::size_t>(m)].name.empty(); ++m) {
            const Emission lamp = emission(atlas, l);
            const Reflectance material = reflectance(atlas, m);
            const auto exact = pair_rgb8<double>(method, lamp, 1, material, seen_by, output);
            worst.float_steps =
                std::max(worst.float_steps,
                         steps(exact, pair_rgb8<float>(method, lamp, 1, material, seen_by, output)));
            worst.half_steps =
                std::max(worst.half_steps,
                         steps(exact, pair_rgb8<Float16>(method, lamp, 1, material, seen_by, output)));
        }
    return worst;
}

TEST(Twins, FloatIsWithinAStepOfDouble) {
    for (const MethodInfo& info : kMethods)
        EXPECT_LE(worst_of(info.method).float_steps, 1) << info.name;
}

// DESIGN.md section 5: summing 64 terms in half costs up to 8-13 steps; products of three numbers cost few.
TEST(Twins, HalfIsAsFarOffAsHalfIs) {
    EXPECT_LE(worst_of(Method::spectral).half_steps, 13);
    EXPECT_GE(worst_of(Method::spectral).half_steps, 2) << "this is no half precision";
    EXPECT_LE(worst_of(Method::tristimulus).half_steps, 6);
    EXPECT_LE(worst_of(Method::rgb).half_steps, 4);
}

// 1 + 2^-11 + 2^-11: each addition rounds back to 1 in half; in float it would not.
TEST(Twins, HalfRoundsAfterEveryOperation) {
    volatile Float16 one = Float16(1), small = Float16(1.0f / 2048);
    const Float16 sum = one + small + small;
    EXPECT_EQ(static_cast<float>(sum), 1.0f);
}

} // namespace
} // namespace metamer
