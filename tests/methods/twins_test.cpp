// The CPU twins in double, float and half, pair by pair.
#include <algorithm>
#include <array>
#include <cstdlib>
#include <gtest/gtest.h>

#include "methods/stock.h"

namespace metamer::test {
namespace {

struct Worst {
    int float_steps = 0, half_steps = 0;
};

std::vector<std::string> materials() {
    std::vector<std::string> out;
    for (const char* set : {"colorchecker", "crayons"})
        for (const std::string& name : find_material_set(set)->materials)
            out.push_back(name);
    return out;
}

std::array<Worst, kMethods.size()> worst_of_all_pairs() {
    Sight sight = stock().sight();
    std::array<Worst, kMethods.size()> out;
    for (const Lamp& lamp : library_lamps()) {
        const Taps taps = taps_for(stock().pair(lamp.name, "cc-red"), {}, sight.tap_count);
        sight.taps = &taps;
        for (const std::string& material : materials()) {
            const Pixel pixel = stock().pair(lamp.name, material);
            for (const MethodInfo& info : kMethods) {
                Worst& worst = out[static_cast<std::size_t>(info.method)];
                const auto exact = shade_rgb8<double>(info.method, pixel, sight);
                worst.float_steps =
                    std::max(worst.float_steps, steps(exact, shade_rgb8<float>(info.method, pixel, sight)));
                worst.half_steps =
                    std::max(worst.half_steps, steps(exact, shade_rgb8<Float16>(info.method, pixel, sight)));
            }
        }
    }
    return out;
}

const Worst& worst_of(Method method) {
    static const auto all = worst_of_all_pairs();
    return all[static_cast<std::size_t>(method)];
}

TEST(Twins, FloatIsWithinAStepOfDouble) {
    for (const MethodInfo& info : kMethods)
        EXPECT_LE(worst_of(info.method).float_steps, 1) << info.name;
}

// DESIGN.md section 5: summing 64 terms in half costs up to 8-13 steps; products of three numbers, eight taps
// and a constant cost next to nothing.
TEST(Twins, HalfIsAsFarOffAsHalfIs) {
    EXPECT_LE(worst_of(Method::spectral).half_steps, 13);
    EXPECT_GE(worst_of(Method::spectral).half_steps, 5) << "this is no half precision";
    for (const Method method : {Method::rgb, Method::tristimulus, Method::prefiltered, Method::folded})
        EXPECT_LE(worst_of(method).half_steps, 1) << method_name(method);
    EXPECT_LE(worst_of(Method::reduced).half_steps, 2);
}

// The guard against half's long sums: sums of four, added up, and k' from the CPU.
TEST(Twins, PartialSumsAreWhatHalfCanBear) {
    EXPECT_LE(worst_of(Method::packed).half_steps, 3);
    EXPECT_GE(worst_of(Method::spectral).half_steps, 2 * worst_of(Method::packed).half_steps);
}

// 1 + 2^-11 + 2^-11: each addition rounds back to 1 in half; in float it would not.
TEST(Twins, HalfRoundsAfterEveryOperation) {
    volatile float one = 1, small = 1.0f / 2048; // not the compiler's to add up
    const Float16 sum = Float16(one) + Float16(small) + Float16(small);
    EXPECT_EQ(static_cast<float>(sum), 1.0f);
}

} // namespace
} // namespace metamer::test
