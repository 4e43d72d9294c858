#include "spectra/library.h"

#include <iterator>

#include "spectra/blackbody.h"
#include "spectra/daylight.h"
#include "spectra/moonlight.h"
#include "spectra/tables.h"

namespace metamer {

namespace {

constexpr const char* kTableT1 = "CIE 15:2004 Table T.1";
constexpr const char* kTableT6 = "CIE 15:2004 Table T.6";
constexpr const char* kTableT7 = "CIE 15:2004 Table T.7";
constexpr const char* kLedTable = "CIE 15:2018, LED illuminants";
constexpr const char* kDaylight = "CIE 15:2004 eq. 3.2-3.6, components of Table T.2";
constexpr const char* kPlanck = "Planck's law, c2 = 1.438776877e-2 m K";

Lamp cie(const char* name, const char* description, const char* source) {
    return {
        name, std::string("CIE ") + name + ", " + description, source, {column(cie_illuminants(), name), {}}};
}

Lamp equal_energy() {
    const Curve flat{{kReferenceGrid.first_nm, kReferenceGrid.last_nm()}, {100, 100}};
    return {"E", "CIE E, equal energy, computed", "CIE 15:2004, by definition, 360..830 nm", {flat, {}}};
}

Lamp krypton() {
    const Curve& table = column(krypton_lines(), "intensity");
    Lamp lamp{
        "krypton",
        "krypton discharge, computed from NIST's lines of the neutral atom, whose intensities are rough",
        krypton_lines().source,
        {}};
    for (std::size_t i = 0; i < table.value.size(); ++i)
        lamp.spectrum.lines.push_back({table.wavelength_nm[i], table.value[i]});
    return lamp;
}

// The thesis's figures 45 and 46, in their order.
std::vector<Lamp> thesis() {
    return {
        equal_energy(),
        cie("B", "direct sunlight, 4874 K", "CIE 1931, as tabulated by Wyszecki and Stiles"),
        cie("C", "average daylight, 6774 K", kTableT1),
        {"D4000",
         "the thesis's \"D < 4000 K\": CIE daylight at its lower limit, 4000 K, computed",
         kDaylight,
         {daylight(kLowestDaylight_k), {}}},
        cie("D55", "mid-morning daylight, 5503 K", kTableT1),
        cie("D65", "daylight, 6504 K", kTableT1),
        {"D25000",
         "the thesis's \"D > 20000 K\": CIE daylight at its upper limit, 25000 K, computed",
         kDaylight,
         {daylight(kHighestDaylight_k), {}}},
        {"moonlight",
         "moonlight, modelled: D55 reddened as the full Moon's B-V asks; no measurement",
         "CIE D55 times (w / 560 nm)^1.14; B-V of the Moon 0.92 (Allen's Astrophysical Quantities), of the "
         "Sun 0.65",
         {moonlight(), {}}},
        {"A2800", "incandescent, black body of 2800 K, computed", kPlanck, {blackbody(2800), {}}},
        {"A3200", "incandescent, black body of 3200 K, computed", kPlanck, {blackbody(3200), {}}},
        cie("F2", "cool white fluorescent, 4230 K", kTableT6),
        cie("F7", "broad-band daylight fluorescent, 6500 K", kTableT6),
        cie("F11", "narrow-band fluorescent, 4000 K", kTableT6),
        {"white-LED",
         "white LED, blue with phosphor, the figures of CIE LED-B3, 4103 K",
         kLedTable,
         {column(cie_illuminants(), "LED-B3"), {}}},
        krypton(),
    };
}

std::vector<Lamp> other_cie() {
    return {
        cie("A", "incandescent, 2856 K", kTableT1),
        cie("D50", "horizon daylight, 5003 K", kTableT1),
        cie("D75", "north sky daylight, 7504 K", kTableT1),
        cie("F1", "daylight fluorescent, 6430 K", kTableT6),
        cie("F3", "white fluorescent, 3450 K", kTableT6),
        cie("F4", "warm white fluorescent, 2940 K", kTableT6),
        cie("F5", "daylight fluorescent, 6350 K", kTableT6),
        cie("F6", "light white fluorescent, 4150 K", kTableT6),
        cie("F8", "broad-band fluorescent, 5000 K", kTableT6),
        cie("F9", "broad-band cool white fluorescent, 4150 K", kTableT6),
        cie("F10", "narrow-band fluorescent, 5000 K", kTableT6),
        cie("F12", "narrow-band fluorescent, 3000 K", kTableT6),
        cie("HP1", "standard high-pressure sodium, 1959 K", kTableT7),
        cie("HP2", "color-enhanced high-pressure sodium, 2506 K", kTableT7),
        cie("HP3", "high-pressure metal halide, 3144 K", kTableT7),
        cie("HP4", "high-pressure metal halide, 4002 K", kTableT7),
        cie("HP5", "high-pressure metal halide, 4039 K", kTableT7),
        cie("LED-B1", "blue LED with phosphor, 2733 K", kLedTable),
        cie("LED-B2", "blue LED with phosphor, 2998 K", kLedTable),
        cie("LED-B3", "blue LED with phosphor, 4103 K", kLedTable),
        cie("LED-B4", "blue LED with phosphor, 5109 K", kLedTable),
        cie("LED-B5", "blue LED with phosphor, 6598 K", kLedTable),
        cie("LED-BH1", "blue LED with phosphor and red LED, 2851 K", kLedTable),
        cie("LED-RGB1", "red, green and blue LEDs, 2840 K", kLedTable),
        cie("LED-V1", "violet LED with phosphor, 2724 K", kLedTable),
        cie("LED-V2", "violet LED with phosphor, 4070 K", kLedTable),
    };
}

struct NistLamp {
    const char* name;
    const char* description;
};

constexpr NistLamp kNistLamps[] = {
    {"NIST-FL-F34-CW", "fluorescent F34, cool white, measured"},
    {"NIST-FL-F34-WW", "fluorescent F34T12, warm white, measured"},
    {"NIST-FL-F32T8-TL850", "fluorescent F32T8/TL850, three narrow bands, measured"},
    {"NIST-INC-60W", "incandescent 60 W, soft white, measured"},
    {"NIST-INC-neodymium", "incandescent, neodymium glass, measured"},
    {"NIST-HPS-C100S54", "high-pressure sodium C100S54, measured"},
    {"NIST-HPS-C100S54C", "high-pressure sodium C100S54C, deluxe, measured"},
    {"NIST-HPS-SDW-T", "high-pressure sodium SDW-T, white, measured"},
    {"NIST-LPS", "low-pressure sodium, measured"},
    {"NIST-MH-MHC100-3K", "metal halide MHC100, 3000 K, measured"},
    {"NIST-MH-MHC100-4K", "metal halide MHC100, 4000 K, measured"},
    {"NIST-HG-H38HT-100", "mercury H38HT-100, clear, measured"},
};

std::vector<Lamp> nist() {
    std::vector<Lamp> lamps;
    for (const NistLamp& lamp : kNistLamps)
        lamps.push_back(
            {lamp.name, lamp.description, nist_lamps().source, {column(nist_lamps(), lamp.name), {}}});
    return lamps;
}

} // namespace

std::span<const Lamp> library_lamps() {
    static const std::vector<Lamp> lamps = [] {
        std::vector<Lamp> all = thesis();
        for (std::vector<Lamp> more : {other_cie(), nist()})
            std::move(more.begin(), more.end(), std::back_inserter(all));
        return all;
    }();
    return lamps;
}

std::span<const std::string> thesis_lamps() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> out;
        for (const Lamp& lamp : thesis())
            out.push_back(lamp.name);
        return out;
    }();
    return names;
}

} // namespace metamer
