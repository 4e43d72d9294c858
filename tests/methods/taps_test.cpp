// Wavelengths chosen and weighted for a scene.
#include "methods/taps.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "color/difference.h"
#include "color/observer.h"
#include "color/resample.h"
#include "methods/tap_problem.h"
#include "methods/tap_weights.h"
#include "spectra/csv.h"
#include "spectra/library.h"

namespace metamer {
namespace {

using testing::ElementsAre;
using testing::IsSupersetOf;
using Spectrum = std::vector<double>;

// Lamps with the pointers that choose_taps takes.
struct Lamps {
    std::vector<ReferenceLamp> lamp;
    std::vector<const ReferenceLamp*> view;

    explicit Lamps(std::vector<ReferenceLamp> all) : lamp(std::move(all)) {
        for (const ReferenceLamp& one : lamp)
            view.push_back(&one);
    }
};

ReferenceLamp lamp_of(const std::string& name) {
    return reference_lamp(find_lamp(name).spectrum);
}

ReferenceLamp lines(std::vector<EmissionLine> all) {
    return reference_lamp(LampSpectrum{{}, std::move(all)});
}

Spectrum spectrum_of(const std::string& material) {
    return resample(find_material(material).spectrum, kReferenceGrid);
}

const Spectrum& perfect() {
    static const Spectrum ones(kReferenceGrid.count, 1.0);
    return ones;
}

// R T^d at evenly spaced thicknesses 0 .. most; media have density 1 at thickness 1.
std::vector<Spectrum> wedge(const Spectrum& medium, const Spectrum& wall, int count, double most = 3) {
    std::vector<Spectrum> out;
    for (int k = 0; k < count; ++k) {
        const double thickness = most * k / (count - 1);
        out.emplace_back(wall);
        for (std::size_t i = 0; i < wall.size(); ++i)
            out.back()[i] *= std::pow(medium[i], thickness);
    }
    return out;
}

struct Errors {
    double mean = 0, most = 0;
};

Errors errors(const Taps& taps, const Lamps& lamps, const std::vector<Spectrum>& seen) {
    Errors out;
    for (std::size_t l = 0; l < lamps.lamp.size(); ++l)
        for (const Spectrum& f : seen) {
            const double e = delta_e_2000(reference_xyz(lamps.lamp[l], f), taps_xyz(taps, l, f));
            out.most = std::max(out.most, e);
            out.mean += e / static_cast<double>(seen.size() * lamps.lamp.size());
        }
    return out;
}

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

struct Scene {
    const char* name;
    std::vector<std::string> lamps;
};

// What a visitor may choose: smooth, banded and line lamps, alone and together.
const std::vector<Scene>& scenes() {
    static const std::vector<Scene> all{{"A", {"A"}},
                                        {"D65", {"D65"}},
                                        {"LED", {"white-LED"}},
                                        {"F2", {"F2"}},
                                        {"F11", {"F11"}},
                                        {"krypton", {"krypton"}},
                                        {"LPS", {"NIST-LPS"}},
                                        {"A+F11+krypton", {"A", "F11", "krypton"}},
                                        {"D65+F2+LED", {"D65", "F2", "white-LED"}}};
    return all;
}

Lamps lamps_of(const Scene& scene) {
    std::vector<ReferenceLamp> lamps;
    for (const std::string& name : scene.lamps)
        lamps.push_back(lamp_of(name));
    return Lamps(std::move(lamps));
}

// The issue asks for 0.5 at 8 taps. Measured: at most 0.43 at 4 taps, 0.25 at 8 (neodymium glass under D65),
// 0.05 as a rule.
TEST(TapsOfAMedium, HoldBetweenTheSamplesUpToDensityThree) {
    for (const std::string& name : find_material_set("media")->materials) {
        const Spectrum medium = spectrum_of(name);
        const std::vector<Spectrum> own = wedge(medium, perfect(), 17),
                                    between = wedge(medium, perfect(), 100);
        for (const Scene& scene : scenes()) {
            const Lamps lamps = lamps_of(scene);
            const Errors four = errors(choose_taps(lamps.view, own, 4), lamps, between);
            EXPECT_LE(four.most, 0.5) << name << " under " << scene.name;
            const Errors eight = errors(choose_taps(lamps.view, own, 8), lamps, between);
            EXPECT_LE(eight.most, 0.3) << name << " under " << scene.name;
        }
    }
}

TEST(TapsOfAMedium, HoldBeforeColoredWalls) {
    const Spectrum medium = spectrum_of("glass-cobalt");
    std::vector<Spectrum> own, between;
    for (const char* wall : {"cc-white", "cc-red", "cc-green", "cc-blue"}) {
        for (const Spectrum& f : wedge(medium, spectrum_of(wall), 13))
            own.push_back(f);
        for (const Spectrum& f : wedge(medium, spectrum_of(wall), 100))
            between.push_back(f);
    }
    for (const Scene& scene : scenes()) {
        const Lamps lamps = lamps_of(scene);
        EXPECT_LE(errors(choose_taps(lamps.view, own, 12), lamps, between).most, 0.5) << scene.name;
    }
}

// What a GPU in half precision makes of it must not be worse than the fit: no great weights that cancel.
TEST(TapsOfAMedium, KeepTheirWeightsSmall) {
    for (const std::string& name : find_material_set("media")->materials) {
        std::vector<Spectrum> own;
        for (const char* wall : {"cc-white", "cc-red", "cc-green", "cc-blue"})
            for (const Spectrum& f : wedge(spectrum_of(name), spectrum_of(wall), 9))
                own.push_back(f);
        for (const Scene& scene : scenes())
            for (const auto& lamp : choose_taps(lamps_of(scene).view, own, 8).weight)
                for (const Xyz& w : lamp)
                    EXPECT_LE(std::max({std::abs(w.x), std::abs(w.y), std::abs(w.z)}), 4)
                        << name << scene.name;
    }
}

// R_B (E + F R_A): linear in two spectra, so that a few taps carry all E and F.
TEST(TapsOfTwoWalls, HoldAtEveryShareOfTheBounce) {
    const Spectrum a = spectrum_of("cc-red"), b = spectrum_of("cc-cyan");
    Spectrum both = a;
    for (std::size_t i = 0; i < both.size(); ++i)
        both[i] *= b[i];
    std::vector<Spectrum> shares;
    for (int k = 0; k <= 50; ++k) {
        shares.push_back(b);
        for (std::size_t i = 0; i < b.size(); ++i)
            shares.back()[i] = b[i] * (1 - 0.02 * k) + 0.02 * k * both[i];
    }
    for (const Scene& scene : scenes()) {
        const Lamps lamps = lamps_of(scene);
        EXPECT_LE(errors(choose_taps(lamps.view, std::vector{b, both}, 4), lamps, shares).most, 0.2)
            << scene.name;
    }
}

// Bins of equal width, weighted by S cmf: what one writes first (their middles; a bin's weight is its sum).
Taps bins(const ReferenceLamp& lamp, int count) {
    constexpr std::size_t kFirst = 20, kEnd = 371; // 380 .. 730 nm
    Taps taps;
    taps.weight.resize(1);
    for (int j = 0; j < count; ++j) {
        const std::size_t from =
            kFirst + (kEnd - kFirst) * static_cast<std::size_t>(j) / static_cast<std::size_t>(count);
        const std::size_t to =
            kFirst + (kEnd - kFirst) * static_cast<std::size_t>(j + 1) / static_cast<std::size_t>(count);
        Xyz sum;
        for (std::size_t i = j == 0 ? 0 : from; i < (j + 1 == count ? kReferenceGrid.count : to); ++i) {
            const ColorMatching& eye = cie_1931_2deg()[i];
            sum = sum + (lamp.power[i] / lamp.k) * Xyz{eye.x, eye.y, eye.z};
        }
        taps.wavelength_nm.push_back(kReferenceGrid.wavelength_nm((from + to) / 2));
        taps.weight[0].push_back(sum);
    }
    return taps;
}

// Every second library lamp and the discharges, the measured and modelled materials.
Errors of_any_material(int count, Taps (*choose)(const ReferenceLamp&, int)) {
    std::vector<Spectrum> materials;
    for (const char* set : {"colorchecker", "crayons"})
        for (const std::string& name : find_material_set(set)->materials)
            materials.push_back(spectrum_of(name));
    std::vector<std::string> names{"krypton", "F11", "NIST-LPS"};
    for (std::size_t i = 0; i < library_lamps().size(); i += 2)
        names.push_back(library_lamps()[i].name);
    Errors all;
    for (const std::string& name : names) {
        const Lamps lamp({lamp_of(name)});
        const Errors e = errors(choose(lamp.lamp[0], count), lamp, materials);
        all.mean += e.mean / static_cast<double>(names.size());
        all.most = std::max(all.most, e.most);
    }
    return all;
}

Taps for_any(const ReferenceLamp& lamp, int count) {
    const ReferenceLamp* one[] = {&lamp};
    return choose_taps(one, {}, count);
}

// Bounds about a third above what was measured.
TEST(TapsOfAnyMaterial, KeepTheirErrorsAndImproveWithTheirCount) {
    struct Bound {
        int count;
        double mean, most;
    };
    double last = 100;
    for (const auto& [count, mean, most] :
         {Bound{4, 4, 30}, Bound{8, 0.25, 3}, Bound{16, 0.04, 0.6}, Bound{32, 0.015, 0.25}}) {
        const Errors taps = of_any_material(count, for_any), plain = of_any_material(count, bins);
        EXPECT_LE(taps.mean, mean) << count;
        EXPECT_LE(taps.most, most) << count;
        EXPECT_LT(5 * taps.mean, plain.mean) << count << ": bins " << plain.mean;
        EXPECT_LT(taps.mean, 0.5 * last) << count;
        last = taps.mean;
    }
}

// A second opinion: fifty measured lamps and 99 measured materials that the project does not hold, where a
// checkout has them beside it. Bins were 0.56 at 16 and 0.15 at 32 on such.
TEST(TapsOfAnyMaterial, HoldForLampsAndMaterialsNeverSeen) {
    const std::string folder = METAMER_SOURCE_DIR "/../shared/spectra/";
    if (!std::filesystem::exists(folder + "lamps.csv"))
        return;
    std::vector<Spectrum> materials;
    for (const Curve& curve :
         read_spectra(folder + "reflectances_ces99.csv", SpectrumKind::reflectance).curves)
        materials.push_back(resample(MaterialSpectrum{curve}, kReferenceGrid));
    double mean = 0, most = 0;
    const SpectrumTable lamps = read_spectra(folder + "lamps.csv", SpectrumKind::emission);
    constexpr std::size_t kStep = 3;
    for (std::size_t i = 0; i < lamps.curves.size(); i += kStep) {
        const Lamps lamp({reference_lamp(LampSpectrum{lamps.curves[i], {}})});
        const Errors e = errors(choose_taps(lamp.view, {}, 16), lamp, materials);
        mean += e.mean * kStep / static_cast<double>(lamps.curves.size());
        most = std::max(most, e.most);
    }
    EXPECT_LE(mean, 0.06);
    EXPECT_LE(most, 1);
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

TEST(TapWeights, NonnegativeOnesAreLeastSquaresAmongTheNonnegative) {
    const Lamps lamps({lamp_of("F2")});
    const std::vector<Spectrum> own = wedge(spectrum_of("liquid-permanganate"), perfect(), 9);
    const TapProblem problem = tap_problem(lamps.view, own);
    const std::vector<std::size_t> taps{80, 120, 160, 180, 220, 260};
    for (std::size_t column = 0; column < 3; ++column) {
        const ColumnWeights best = nonnegative_weights(problem, taps, column);
        EXPECT_LE(signed_weights(problem, taps, column).error, best.error * (1 + 1e-9));
        const auto error = [&](const std::vector<double>& w) {
            double sum = 0;
            for (std::size_t r = 0; r < problem.rows; ++r) {
                double off = -problem.target[r * 3 + column];
                const double visible = problem.visible[r * 3 + column];
                for (std::size_t j = 0; j < taps.size(); ++j) {
                    const double term = w[j] * problem.spectrum[r][taps[j]];
                    off += term;
                    sum += std::pow(kTermError * term * visible, 2);
                }
                sum += std::pow(off * visible, 2);
            }
            return std::sqrt(sum);
        };
        EXPECT_NEAR(error(best.weight), best.error, 1e-9 * best.error);
        // No weight can be moved from one tap to another to gain.
        for (std::size_t from = 0; from < taps.size(); ++from)
            for (std::size_t to = 0; to < taps.size(); ++to) {
                if (from == to)
                    continue;
                std::vector<double> moved = best.weight;
                const double step = std::min(1e-4, moved[from]);
                moved[from] -= step;
                moved[to] += step;
                EXPECT_GE(error(moved), best.error * (1 - 1e-9)) << column << ' ' << from << ' ' << to;
            }
    }
}

TEST(TapProblem, WeighsAnErrorAsTheEyeDoes) {
    // A thousandth of Y more, gray: as CIEDE2000 says it.
    const Lamps lamps({lamp_of("D65")});
    const std::vector<Spectrum> own{Spectrum(kReferenceGrid.count, 0.3)};
    const TapProblem problem = tap_problem(lamps.view, own);
    const Xyz gray = reference_xyz(lamps.lamp[0], own[0]);
    EXPECT_NEAR(problem.visible[1] * 1e-3, delta_e_2000(gray, {gray.x, gray.y + 1e-3, gray.z}), 0.02);
    EXPECT_NEAR(problem.target[1], 0.3, 1e-12);
    EXPECT_NEAR(problem.white[1], 1, 1e-12);
}

} // namespace
} // namespace metamer
