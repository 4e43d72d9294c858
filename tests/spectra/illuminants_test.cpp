// The library's lamps against published chromaticities and against each other.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "color/colorimetry.h"
#include "color/resample.h"
#include "spectra/blackbody.h"
#include "spectra/csv.h"
#include "spectra/daylight.h"
#include "spectra/library.h"
#include "spectra/tables.h"

namespace metamer {
namespace {

struct Published {
    const char* lamp;
    double x, y;
};

// CIE 15:2004: A, C, D50, D55, D65, D75 Table T.3, F1-F12 Table T.6, HP1-HP5 Table T.7; B: Wyszecki and
// Stiles (1982); LED-*: CIE 15:2018. All for the 2-degree observer.
constexpr Published kPublished[] = {
    {"A", 0.44758, 0.40745},     {"B", 0.34842, 0.35161},       {"C", 0.31006, 0.31616},
    {"D50", 0.34567, 0.35851},   {"D55", 0.33243, 0.34744},     {"D65", 0.31272, 0.32903},
    {"D75", 0.29903, 0.31488},   {"E", 1.0 / 3, 1.0 / 3},       {"F1", 0.3131, 0.3371},
    {"F2", 0.3721, 0.3751},      {"F3", 0.4091, 0.3941},        {"F4", 0.4402, 0.4031},
    {"F5", 0.3138, 0.3452},      {"F6", 0.3779, 0.3882},        {"F7", 0.3129, 0.3292},
    {"F8", 0.3458, 0.3586},      {"F9", 0.3741, 0.3727},        {"F10", 0.3458, 0.3588},
    {"F11", 0.3805, 0.3769},     {"F12", 0.4370, 0.4042},       {"HP1", 0.5330, 0.4150},
    {"HP2", 0.4778, 0.4158},     {"HP3", 0.4302, 0.4075},       {"HP4", 0.3812, 0.3797},
    {"HP5", 0.3776, 0.3713},     {"LED-B1", 0.4560, 0.4078},    {"LED-B2", 0.4357, 0.4012},
    {"LED-B3", 0.3756, 0.3723},  {"LED-B4", 0.3422, 0.3502},    {"LED-B5", 0.3118, 0.3236},
    {"LED-BH1", 0.4474, 0.4066}, {"LED-RGB1", 0.4557, 0.4211},  {"LED-V1", 0.4548, 0.4044},
    {"LED-V2", 0.3781, 0.3775},  {"white-LED", 0.3756, 0.3723},
};

Chromaticity chromaticity_of(const LampSpectrum& lamp) {
    return chromaticity(reference_white(lamp));
}

TEST(Illuminants, HaveThePublishedChromaticities) {
    // The published figures are sums at 5 nm; between 5 nm and 1 nm lines of the F series move by up to
    // 0.0003.
    constexpr double kTolerance = 0.0004;
    for (const Published& p : kPublished) {
        const Chromaticity c = chromaticity_of(find_lamp(p.lamp).spectrum);
        EXPECT_NEAR(c.x, p.x, kTolerance) << p.lamp;
        EXPECT_NEAR(c.y, p.y, kTolerance) << p.lamp;
    }
}

TEST(Illuminants, BeginWithTheThesisFifteen) {
    EXPECT_THAT(thesis_lamps(),
                testing::ElementsAre("E", "B", "C", "D4000", "D55", "D65", "D25000", "moonlight", "A2800",
                                     "A3200", "F2", "F7", "F11", "white-LED", "krypton"));
    for (std::size_t i = 0; i < thesis_lamps().size(); ++i)
        EXPECT_EQ(library_lamps()[i].name, thesis_lamps()[i]);
}

TEST(Illuminants, FitOneAtlasAndAreTold) {
    EXPECT_LE(library_lamps().size(), 63u);
    std::set<std::string> names;
    for (const Lamp& lamp : library_lamps()) {
        EXPECT_TRUE(names.insert(lamp.name).second) << lamp.name;
        EXPECT_FALSE(lamp.description.empty()) << lamp.name;
        EXPECT_FALSE(lamp.source.empty()) << lamp.name;
        EXPECT_GT(sample_lamp(lamp.spectrum).peak, 0) << lamp.name;
    }
    for (const char* prefix : {"F", "HP", "LED-B", "NIST-"})
        for (const std::string& name : names)
            if (name.starts_with(prefix)) {
                EXPECT_EQ(find_lamp(name).name, name);
            }
    EXPECT_EQ(std::count_if(names.begin(), names.end(), [](auto& n) { return n.starts_with("NIST-"); }), 12);
}

TEST(Illuminants, SayWhatIsNotMeasured) {
    for (const char* name : {"E", "D4000", "D25000", "A2800", "A3200", "krypton"})
        EXPECT_THAT(find_lamp(name).description, testing::HasSubstr("computed")) << name;
    EXPECT_THAT(find_lamp("moonlight").description, testing::HasSubstr("modelled"));
    EXPECT_THAT(find_lamp("white-LED").description, testing::HasSubstr("LED-B3"));
}

TEST(Illuminants, TablesTellTheirSource) {
    for (const SpectrumTable* table :
         {&cie_illuminants(), &nist_lamps(), &krypton_lines(), &daylight_components(), &colorchecker()}) {
        EXPECT_FALSE(table->title.empty());
        EXPECT_FALSE(table->source.empty()) << table->title;
        EXPECT_FALSE(table->unit.empty()) << table->title;
    }
    EXPECT_THAT(krypton_lines().unit, testing::HasSubstr("rough"));
}

TEST(Daylight, RebuildsTheTablesOfD50ToD75) {
    for (const auto& [name, nominal_k] :
         {std::pair{"D50", 5000.0}, {"D55", 5500.0}, {"D65", 6500.0}, {"D75", 7500.0}}) {
        const Curve built = daylight(nominal_k * 1.4388 / 1.4380);
        const Curve& table = column(cie_illuminants(), name);
        for (std::size_t i = 0; i < table.value.size(); ++i) {
            // The tables are printed to three decimals.
            EXPECT_NEAR(value_at_held(built, table.wavelength_nm[i]), table.value[i], 0.001)
                << name << " at " << table.wavelength_nm[i];
        }
    }
}

TEST(Daylight, KeepsItsLocusAtBothLimits) {
    for (const double cct_k : {4000.0, 6999.0, 7001.0, 25000.0}) {
        const Chromaticity wanted = daylight_chromaticity(cct_k);
        const Chromaticity got = chromaticity_of({daylight(cct_k), {}});
        EXPECT_NEAR(got.x, wanted.x, 0.0005) << cct_k;
        EXPECT_NEAR(got.y, wanted.y, 0.0005) << cct_k;
    }
    // The two polynomials meet at 7000 K.
    EXPECT_NEAR(daylight_chromaticity(6999.999).x, daylight_chromaticity(7000.001).x, 1e-4);
}

TEST(Blackbody, PeaksWhereWienSays) {
    for (const double t : {4000.0, 5000.0, 6000.0, 7000.0}) {
        const Curve c = blackbody(t);
        const auto peak = std::max_element(c.value.begin(), c.value.end()) - c.value.begin();
        EXPECT_NEAR(c.wavelength_nm[static_cast<std::size_t>(peak)], 2.897771955e6 / t, 0.5) << t;
    }
}

TEST(Blackbody, HasThePowersOfPlancksLaw) {
    const double t = 3000, c2 = 1.438776877e7;
    const Curve c = blackbody(t);
    EXPECT_DOUBLE_EQ(value_at_held(c, 560), 100);
    const double ratio =
        std::pow(800.0 / 400, 5) * (std::exp(c2 / (800 * t)) - 1) / (std::exp(c2 / (400 * t)) - 1);
    EXPECT_NEAR(value_at_held(c, 400) / value_at_held(c, 800), ratio, 1e-12 * ratio);
    // CIE A is a black body of 2848 K by the radiation constant 1.435e-2 m K: 2855.5 K by today's.
    const Curve& a = column(cie_illuminants(), "A");
    const Curve b = blackbody(2848 * 1.438776877 / 1.435);
    for (std::size_t i = 0; i < a.value.size(); ++i)
        EXPECT_NEAR(value_at_held(b, a.wavelength_nm[i]), a.value[i], 6e-4) << "printed to six digits";
    for (const double edge_k : {kColdestBlackbody_k, kHottestBlackbody_k})
        for (const double v : blackbody(edge_k).value)
            EXPECT_TRUE(std::isfinite(v) && v > 0) << edge_k;
}

TEST(Illuminants, ComputeTheThesisLampsAtTheirTemperatures) {
    const auto values = [](const char* name) { return find_lamp(name).spectrum.continuum.value; };
    EXPECT_EQ(values("D4000"), daylight(4000).value);
    EXPECT_EQ(values("D25000"), daylight(25000).value);
    EXPECT_EQ(values("A2800"), blackbody(2800).value);
    EXPECT_EQ(values("A3200"), blackbody(3200).value);
}

TEST(Krypton, IsLinesOnly) {
    const Lamp lamp = find_lamp("krypton");
    EXPECT_TRUE(lamp.spectrum.continuum.value.empty());
    EXPECT_GT(lamp.spectrum.lines.size(), 200u);
    // The green line at 557.03 nm and the yellow one at 587.09 nm carry the visible light.
    for (const double strong_nm : {557.0289, 587.0914})
        EXPECT_TRUE(std::any_of(lamp.spectrum.lines.begin(), lamp.spectrum.lines.end(),
                                [&](const EmissionLine& l) {
                                    return std::abs(l.wavelength_nm - strong_nm) < 0.001 && l.power >= 2000;
                                }))
            << strong_nm;
}

// Modelled, with a measurement as a second opinion where it is at hand.
TEST(Moonlight, IsRedderThanDaylightAndNearAMeasurement) {
    const Chromaticity moon = chromaticity_of(find_lamp("moonlight").spectrum);
    const Chromaticity day = chromaticity_of(find_lamp("D55").spectrum);
    EXPECT_GT(moon.x, day.x + 0.02);
    const std::filesystem::path measured = METAMER_SOURCE_DIR "/../shared/spectra/moonlight_1nm.csv";
    if (!std::filesystem::exists(measured))
        return;
    SpectrumTable table = read_spectra(measured.string(), SpectrumKind::emission);
    const Chromaticity seen = chromaticity_of({table.curves.front(), {}});
    // One night's air and the Moon's phase move it by about as much.
    EXPECT_LT(std::hypot(moon.x - seen.x, moon.y - seen.y), 0.01);
}

} // namespace
} // namespace metamer
