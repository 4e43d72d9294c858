// Colors from the 8-bit rows against the 1 nm reference, over whole tables. The bounds stand a little above
// what is measured; the figures are in docs/model.md.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>

#include <gtest/gtest.h>

#include "atlas/atlas.h"
#include "atlas/samples.h"
#include "color/colorimetry.h"
#include "color/difference.h"
#include "color/resample.h"
#include "spectra/csv.h"

namespace metamer {
namespace {

struct Differences {
    double mean = 0, greatest = 0;
    std::string worst;
};

Xyz from_rows(const Emission& s, const Reflectance& r, const GridObserver& o) {
    Xyz sum;
    double k = 0;
    for (std::size_t i = 0; i < kIntervals; ++i) {
        sum = sum + s.value[i] * r.value[i] * Xyz{o.x[i], o.y[i], o.z[i]};
        k += s.value[i] * o.y[i];
    }
    return (1 / k) * sum;
}

// One atlas takes 63 rows; a row does not depend on its neighbors, so that each may have an atlas of its own.
// `known`: materials' levels are chosen for these lamps, as in an atlas that holds them; else for lamps never
// seen.
Differences differences(Quantization quantization, const std::vector<Lamp>& lamps,
                        const std::vector<Material>& materials, bool known = false) {
    const GridObserver seen_by = exact_observer(empty_atlas(quantization));
    std::vector<Reflectance> rows;
    std::vector<std::vector<double>> fine;
    Atlas lit = empty_atlas(quantization);
    for (std::size_t l = 0; known && l < lamps.size(); ++l)
        add_lamp(lit, lamps[l]);
    for (const Material& material : materials) {
        Atlas atlas = lit;
        rows.push_back(
            reflectance(atlas, add_material(atlas, material,
                                            known ? std::span<const Lamp>(lamps) : std::span<const Lamp>())));
        fine.push_back(resample(material.spectrum, kReferenceGrid));
    }
    Differences out;
    for (const Lamp& lamp : lamps) {
        Atlas atlas = empty_atlas(quantization);
        const Emission row = emission(atlas, add_lamp(atlas, lamp));
        const ReferenceLamp reference = reference_lamp(lamp.spectrum);
        for (std::size_t m = 0; m < materials.size(); ++m) {
            const double d =
                delta_e_2000(reference_xyz(reference, fine[m]), from_rows(row, rows[m], seen_by));
            out.mean += d / static_cast<double>(lamps.size() * materials.size());
            if (!(d <= out.greatest)) {
                out.greatest = d;
                out.worst = lamp.name + " on " + materials[m].name;
            }
        }
    }
    std::cout << name_of(quantization) << ": mean " << out.mean << ", greatest " << out.greatest << ", "
              << out.worst << "\n";
    return out;
}

std::vector<Material> members(std::initializer_list<const char*> sets) {
    std::vector<Material> out;
    for (const char* set : sets)
        for (const std::string& name : find_material_set(set)->materials)
            out.push_back(find_material(name));
    return out;
}

const std::vector<Lamp>& every_lamp() {
    static const std::vector<Lamp> all(library_lamps().begin(), library_lamps().end());
    return all;
}

TEST(Accuracy, OfTheLibrary) {
    const auto materials = members({"colorchecker", "crayons"});
    const Differences d = differences(Quantization::weighted, every_lamp(), materials);
    EXPECT_LE(d.mean, 0.02);
    EXPECT_LE(d.greatest, 0.65) << d.worst;
    const Differences known = differences(Quantization::weighted, every_lamp(), materials, true);
    EXPECT_LE(known.mean, 0.015);
    EXPECT_LE(known.greatest, 0.5) << known.worst;
    const Differences thesis = differences(Quantization::thesis, every_lamp(), materials);
    EXPECT_GE(thesis.mean, 3 * d.mean);
    EXPECT_GE(thesis.greatest, 3 * d.greatest);
}

// Levels chosen for the very lamp that a material is seen under, as `metamer measure` does.
TEST(Accuracy, OfPairs) {
    double sum = 0, greatest = 0, count = 0;
    const GridObserver seen_by = exact_observer(empty_atlas());
    for (const Lamp& lamp : every_lamp()) {
        Atlas atlas = empty_atlas();
        const Emission row = emission(atlas, add_lamp(atlas, lamp));
        const ReferenceLamp reference = reference_lamp(lamp.spectrum);
        for (const Material& material : members({"colorchecker"})) {
            const Reflectance r = reflectance(atlas, add_material(atlas, material, {&lamp, 1}));
            const double d =
                delta_e_2000(reference_xyz(reference, resample(material.spectrum, kReferenceGrid)),
                             from_rows(row, r, seen_by));
            sum += d;
            ++count;
            greatest = std::max(greatest, d);
        }
    }
    std::cout << "pairs: mean " << sum / count << ", greatest " << greatest << "\n";
    EXPECT_LE(sum / count, 0.01);
    EXPECT_LE(greatest, 0.15);
}

TEST(Accuracy, OfLinesAndBands) {
    std::vector<Lamp> lamps;
    for (const char* name : {"line:435.8", "line:450", "line:546.1", "line:589.3", "line:632.8",
                             "gauss:420:20", "gauss:470:20", "gauss:525:35", "gauss:590:15", "gauss:630:20"})
        lamps.push_back(find_lamp(name));
    const Differences d = differences(Quantization::weighted, lamps, members({"colorchecker", "crayons"}));
    EXPECT_LE(d.mean, 0.08);
    EXPECT_LE(d.greatest, 0.7) << d.worst;
}

// A band on a dark ground under single lines: the ground is a few levels of 255.
TEST(Accuracy, OfTheDarkBesideTheBright) {
    std::vector<Lamp> lamps;
    std::vector<Material> materials;
    for (int nm = 430; nm <= 670; nm += 10)
        lamps.push_back(line_lamp("line " + std::to_string(nm), nm));
    for (const double center_nm : {450.0, 500.0, 550.0, 600.0, 650.0})
        for (const double ground : {0.02, 0.05}) {
            const auto value = [&](std::size_t i) {
                const double t = (kThesisGrid.wavelength_nm(i) - center_nm) / 20;
                return ground + 0.6 * std::exp(-t * t);
            };
            materials.push_back({"band", "", "", {curve_on_grid(value)}});
        }
    const Differences d = differences(Quantization::weighted, lamps, materials);
    EXPECT_LE(d.mean, 0.12);
    EXPECT_LE(d.greatest, 0.85) << d.worst;
}

TEST(Accuracy, OfTheDark) {
    std::vector<Material> dark{flat_material("flat 0.01", 0.01), flat_material("flat 0.001", 0.001)};
    for (Material material : members({"colorchecker"})) {
        for (double& value : material.spectrum.curve.value)
            value *= 0.02;
        dark.push_back(material);
    }
    const Differences d = differences(Quantization::weighted, every_lamp(), dark);
    EXPECT_LE(d.mean, 0.005);
    EXPECT_LE(d.greatest, 0.06) << d.worst;
}

// The second opinion: the table of the project's notes, 45 lamps x 64 materials.
std::vector<std::pair<std::string, Curve>> shared(const std::string& file, SpectrumKind kind) {
    const SpectrumTable table = read_spectra(METAMER_SOURCE_DIR "/../shared/spectra/" + file, kind);
    std::vector<std::pair<std::string, Curve>> out;
    for (std::size_t n = 0; n < table.names.size(); ++n)
        out.emplace_back(table.names[n], table.curves[n]);
    return out;
}

bool is_of_the_table(const std::string& illuminant) {
    static const std::vector<std::string> daylights{"A", "B", "C", "D50", "D55", "D65", "D75", "E"};
    return std::find(daylights.begin(), daylights.end(), illuminant) != daylights.end() ||
           (illuminant.front() == 'F' && illuminant.find('.') == std::string::npos);
}

TEST(Accuracy, OfTheSharedTable) {
    if (!std::filesystem::exists(METAMER_SOURCE_DIR "/../shared/spectra/lamps.csv"))
        GTEST_SKIP() << "the shared spectra are not at hand";
    std::vector<Lamp> lamps;
    for (const auto& [name, curve] : shared("illuminants.csv", SpectrumKind::emission))
        if (is_of_the_table(name))
            lamps.push_back({name, "", "", {curve, {}}});
    const auto measured = shared("lamps.csv", SpectrumKind::emission);
    for (std::size_t n = 0; n < measured.size(); n += 2)
        lamps.push_back({measured[n].first, "", "", {measured[n].second, {}}});
    std::vector<Material> materials;
    for (const auto& [name, curve] : shared("reflectances.csv", SpectrumKind::reflectance))
        materials.push_back({name, "", "", {curve}});
    const auto ces = shared("reflectances_ces99.csv", SpectrumKind::reflectance);
    for (std::size_t n = 0; n < ces.size(); n += 4)
        materials.push_back({ces[n].first, "", "", {ces[n].second}});
    ASSERT_EQ(lamps.size(), 45u);
    ASSERT_EQ(materials.size(), 64u);
    const Differences unseen = differences(Quantization::weighted, lamps, materials);
    EXPECT_LE(unseen.mean, 0.02);
    EXPECT_LE(unseen.greatest, 0.46) << unseen.worst;
    const Differences d = differences(Quantization::weighted, lamps, materials, true);
    EXPECT_LE(d.mean, 0.015);
    EXPECT_LE(d.greatest, 0.3) << d.worst;
}

} // namespace
} // namespace metamer
