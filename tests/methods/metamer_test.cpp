// The project's namesake: two materials that are one color under one lamp and two under another.
#include <array>
#include <cmath>
#include <gtest/gtest.h>

#include "color/difference.h"
#include "color/resample.h"
#include "methods/three_numbers.h"
#include "spectra/library.h"

namespace metamer {
namespace {

using Vector = std::array<double, kIntervals>;

double dot(const Vector& a, const Vector& b) {
    double sum = 0;
    for (std::size_t i = 0; i < kIntervals; ++i)
        sum += a[i] * b[i];
    return sum;
}

// A metameric black under the lamp (Wyszecki 1953): what is left of a wave once its part along each weighted
// color matching function is taken away.
Vector metameric_black(const Emission& lamp, const GridObserver& observer) {
    std::array<Vector, 3> basis{observer.x, observer.y, observer.z};
    Vector black;
    for (std::size_t i = 0; i < kIntervals; ++i)
        black[i] = std::sin(0.11 * static_cast<double>(i) * static_cast<double>(i) / 4);
    for (std::size_t a = 0; a < 3; ++a) {
        for (std::size_t i = 0; i < kIntervals; ++i)
            basis[a][i] *= lamp.value[i];
        for (std::size_t b = 0; b < a; ++b) {
            const double part = dot(basis[a], basis[b]) / dot(basis[b], basis[b]);
            for (std::size_t i = 0; i < kIntervals; ++i)
                basis[a][i] -= part * basis[b][i];
        }
    }
    for (int round = 0; round < 2; ++round) // twice is exact
        for (const Vector& along : basis) {
            const double part = dot(black, along) / dot(along, along);
            for (std::size_t i = 0; i < kIntervals; ++i)
                black[i] -= part * along[i];
        }
    return black;
}

TEST(MetamericPair, IsOneColorUnderOneLampAndTwoUnderAnother) {
    const GridObserver observer = sampled_observer();
    const Emission d65 = sample_lamp(find_lamp("D65").spectrum).emission;
    const Emission f11 = sample_lamp(find_lamp("F11").spectrum).emission;
    const Vector black = metameric_black(d65, observer);
    Reflectance plain, wavy;
    for (std::size_t i = 0; i < kIntervals; ++i) {
        plain.value[i] = 0.5;
        wavy.value[i] = 0.5 + 0.25 * black[i];
        ASSERT_GE(wavy.value[i], 0);
        ASSERT_LE(wavy.value[i], 1);
    }
    EXPECT_LT(delta_e_2000(grid_xyz(d65, plain, observer), grid_xyz(d65, wavy, observer)), 1e-6);
    EXPECT_GT(delta_e_2000(grid_xyz(f11, plain, observer), grid_xyz(f11, wavy, observer)), 2);
    // Three numbers cannot know: under D65 both materials have the same, so they stay one color under any
    // lamp.
    const WorkingSpace& srgb = working_spaces()[0];
    EXPECT_LT(delta_e_2000(grid_xyz(white_emission(srgb), plain, observer),
                           grid_xyz(white_emission(srgb), wavy, observer)),
              1e-6);
}

} // namespace
} // namespace metamer
