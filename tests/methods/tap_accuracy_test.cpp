// How far taps part from the reference: in media, between walls, for any material.
#include <filesystem>

#include <gtest/gtest.h>

#include "color/observer.h"
#include "methods/tap_scenes.h"
#include "spectra/csv.h"

namespace metamer::test {
namespace {

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

} // namespace
} // namespace metamer::test
