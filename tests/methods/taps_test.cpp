// Wavelengths chosen and weighted for a scene.
#include "methods/taps.h"

#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "methods/tap_problem.h"
#include "methods/tap_scenes.h"
#include "methods/tap_weights.h"

namespace metamer::test {
namespace {

using testing::ElementsAre;
using testing::IsSupersetOf;

bool all_nonnegative(const Taps& taps) {
    for (const auto& lamp : taps.weight)
        for (const Xyz& w : lamp)
            if (!(w.x >= 0 && w.y >= 0 && w.z >= 0))
                return false;
    return true;
}

void expect_xyz(const Xyz& a, const Xyz& b, double tolerance) {
    EXPECT_NEAR(a.x, b.x, tolerance);
    EXPECT_NEAR(a.y, b.y, tolerance);
    EXPECT_NEAR(a.z, b.z, tolerance);
}

// Mercury's strong lines, rounded to the grid.
std::vector<EmissionLine> four_lines() {
    return {{436, 1}, {546, 2}, {578, 1.5}, {611, 0.3}};
}

TEST(Taps, AreALampsLinesWhenItHasNoMore) {
    const Lamps lamps({lines(four_lines())});
    std::mt19937 random(3);
    Spectrum f(kReferenceGrid.count);
    for (double& v : f)
        v = std::uniform_real_distribution(0.0, 1.0)(random);
    const Taps four = choose_taps(lamps.view, {}, 4);
    EXPECT_THAT(four.wavelength_nm, ElementsAre(436, 546, 578, 611));
    expect_xyz(taps_xyz(four, 0, f), reference_xyz(lamps.lamp[0], f), 1e-15);
    // More taps than lines: the rest see nothing.
    const Taps eight = choose_taps(lamps.view, {}, 8);
    ASSERT_EQ(eight.wavelength_nm.size(), 8u);
    EXPECT_THAT(eight.wavelength_nm, IsSupersetOf(four.wavelength_nm));
    EXPECT_TRUE(std::is_sorted(eight.wavelength_nm.begin(), eight.wavelength_nm.end(), std::less_equal<>()));
    expect_xyz(taps_xyz(eight, 0, f), reference_xyz(lamps.lamp[0], f), 1e-15);
}

TEST(Taps, FindLinesAmongFaintLight) {
    // The same lines over a continuum of a millionth of their light: four taps cannot do better than the
    // lines.
    LampSpectrum spectrum{{{380, 780}, {1e-8, 1e-8}}, four_lines()};
    const Lamps lamps({reference_lamp(spectrum)});
    EXPECT_THAT(choose_taps(lamps.view, {}, 4).wavelength_nm, ElementsAre(436, 546, 578, 611));
    EXPECT_THAT(choose_taps(lamps.view, wedge(spectrum_of("glass-amber"), perfect(), 9), 6).wavelength_nm,
                IsSupersetOf({436.0, 546.0, 578.0}));
}

TEST(Taps, FindTwoLampsLinesTogether) {
    const Lamps lamps({lines({{450, 1}, {600, 1}}), lines({{520, 1}, {600, 2}, {650, 1}})});
    const Taps taps = choose_taps(lamps.view, {}, 4);
    EXPECT_THAT(taps.wavelength_nm, ElementsAre(450, 520, 600, 650));
    EXPECT_EQ(taps.weight[0][1].y, 0) << "520 nm is the other lamp's";
    EXPECT_EQ(taps.weight[1][0].y, 0) << "450 nm is the other lamp's";
    expect_xyz(taps_xyz(taps, 1, spectrum_of("cc-red")), reference_xyz(lamps.lamp[1], spectrum_of("cc-red")),
               1e-15);
}

TEST(Taps, OfSomeLampsAreTheirsInTheirOrder) {
    const Lamps lamps({lines({{450, 1}, {600, 1}}), lines({{520, 1}, {600, 2}}), lines({{650, 1}})});
    const Taps all = choose_taps(lamps.view, {}, 4);
    const Taps some = of_lamps(all, std::vector<std::size_t>{2, 0});
    EXPECT_EQ(some.wavelength_nm, all.wavelength_nm);
    ASSERT_EQ(some.weight.size(), 2u);
    const Spectrum red = spectrum_of("cc-red");
    expect_xyz(taps_xyz(some, 0, red), reference_xyz(lamps.lamp[2], red), 1e-15);
    expect_xyz(taps_xyz(some, 1, red), reference_xyz(lamps.lamp[0], red), 1e-15);
}

TEST(Taps, IncludeTheStrongLinesOfDischarges) {
    const auto near = [](const Taps& taps, double nm) {
        return std::any_of(taps.wavelength_nm.begin(), taps.wavelength_nm.end(),
                           [&](double w) { return std::abs(w - nm) < 1.5; });
    };
    const Taps krypton = choose_taps(Lamps({lamp_of("krypton")}).view, {}, 8);
    EXPECT_TRUE(near(krypton, 557.0)) << testing::PrintToString(krypton.wavelength_nm);
    EXPECT_TRUE(near(krypton, 587.1)) << testing::PrintToString(krypton.wavelength_nm);
    const Taps sodium = choose_taps(Lamps({lamp_of("NIST-LPS")}).view, {}, 4);
    EXPECT_TRUE(near(sodium, 589) || near(sodium, 590)) << testing::PrintToString(sodium.wavelength_nm);
}

TEST(Taps, ShowWhiteExactlyUnderEveryLamp) {
    const std::vector<Spectrum> own = wedge(spectrum_of("glass-cobalt"), perfect(), 9);
    for (const Lamp& lamp : library_lamps()) {
        const Lamps lamps({reference_lamp(lamp.spectrum)});
        const Xyz white = reference_xyz(lamps.lamp[0], perfect());
        expect_xyz(taps_xyz(choose_taps(lamps.view, {}, 4), 0, perfect()), white, 1e-11);
        expect_xyz(taps_xyz(choose_taps(lamps.view, own, 8), 0, perfect()), white, 1e-11);
    }
}

TEST(Taps, AreAsManyAsAskedForDistinctAscendingAndOnTheGrid) {
    const Lamps lamps({lamp_of("A"), lamp_of("NIST-LPS")});
    for (const int count : kTapCounts) {
        const Taps taps = choose_taps(lamps.view, {}, count);
        ASSERT_EQ(taps.wavelength_nm.size(), static_cast<std::size_t>(count));
        ASSERT_EQ(taps.weight.size(), 2u);
        EXPECT_EQ(taps.weight[0].size(), taps.wavelength_nm.size());
        EXPECT_EQ(taps.weight[1].size(), taps.wavelength_nm.size());
        EXPECT_TRUE(
            std::is_sorted(taps.wavelength_nm.begin(), taps.wavelength_nm.end(), std::less_equal<>()));
        for (const double w : taps.wavelength_nm)
            EXPECT_EQ(w, std::round(w));
        EXPECT_GE(taps.wavelength_nm.front(), 360);
        EXPECT_LE(taps.wavelength_nm.back(), 830);
    }
}

TEST(Taps, AreTheSameEveryTime) {
    const Lamps lamps({lamp_of("D65"), lamp_of("F11"), lamp_of("krypton")});
    const std::vector<Spectrum> own = wedge(spectrum_of("liquid-permanganate"), spectrum_of("cc-yellow"), 17);
    const Taps once = choose_taps(lamps.view, own, 8), again = choose_taps(lamps.view, own, 8);
    EXPECT_EQ(once.wavelength_nm, again.wavelength_nm);
    for (std::size_t l = 0; l < 3; ++l)
        for (std::size_t j = 0; j < 8; ++j)
            expect_xyz(once.weight[l][j], again.weight[l][j], 0);
}

TEST(Taps, WeighNothingBelowZeroForAnyMaterial) {
    for (const Lamp& lamp : library_lamps())
        for (const int count : {4, 16})
            EXPECT_TRUE(all_nonnegative(choose_taps(Lamps({reference_lamp(lamp.spectrum)}).view, {}, count)))
                << lamp.name << ' ' << count;
}

TEST(Taps, WeighBelowZeroOnlyWhereThatPays) {
    const Lamps lamps({lamp_of("D65")});
    for (const Material& medium : library_materials().last(find_material_set("media")->materials.size())) {
        const std::vector<Spectrum> own = wedge(resample(medium.spectrum, kReferenceGrid), perfect(), 17);
        for (const int count : {4, 6, 8}) {
            const Taps taps = choose_taps(lamps.view, own, count);
            std::vector<std::size_t> at;
            for (const double w : taps.wavelength_nm)
                at.push_back(static_cast<std::size_t>(w - kReferenceGrid.first_nm));
            const TapProblem problem = tap_problem(lamps.view, own);
            for (std::size_t c = 0; c < 3; ++c) {
                const bool negative =
                    std::any_of(taps.weight[0].begin(), taps.weight[0].end(), [&](const Xyz& w) {
                        return (c == 0 ? w.x : c == 1 ? w.y : w.z) < 0;
                    });
                const double gain =
                    nonnegative_weights(problem, at, c).error - signed_weights(problem, at, c).error;
                EXPECT_EQ(negative, gain > kWorthNegative) << medium.name << ' ' << count << ' ' << c;
            }
        }
    }
}

TEST(Taps, StandDegenerateSpectra) {
    const Lamps lamps({lamp_of("D65"), lamp_of("F11")});
    const std::vector<Spectrum> black(3, Spectrum(kReferenceGrid.count, 0.0)), flat(5, perfect());
    std::vector<Spectrum> line(1, Spectrum(kReferenceGrid.count, 0.0));
    line[0][200] = 1;
    for (const auto& own : {black, flat, line}) {
        const Taps taps = choose_taps(lamps.view, own, 8);
        for (std::size_t l = 0; l < 2; ++l) {
            for (const Xyz& w : taps.weight[l])
                EXPECT_TRUE(std::isfinite(w.x) && std::isfinite(w.y) && std::isfinite(w.z));
            expect_xyz(taps_xyz(taps, l, perfect()), reference_xyz(lamps.lamp[l], perfect()), 1e-11);
        }
    }
    EXPECT_THAT(choose_taps(lamps.view, line, 8).wavelength_nm, testing::Contains(560))
        << "the one wavelength that matters";
}

TEST(Taps, StandLampsOfOneLine) {
    const Lamps lamps({lines({{589, 1}})});
    for (const int count : {1, 4, 32}) {
        const Taps taps = choose_taps(lamps.view, {}, count);
        EXPECT_THAT(taps.wavelength_nm, testing::Contains(589));
        ASSERT_EQ(taps.wavelength_nm.size(), static_cast<std::size_t>(count));
        expect_xyz(taps_xyz(taps, 0, spectrum_of("cc-blue")),
                   reference_xyz(lamps.lamp[0], spectrum_of("cc-blue")), 1e-15);
    }
}

} // namespace
} // namespace metamer::test
