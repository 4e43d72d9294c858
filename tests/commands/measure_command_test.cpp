// metamer measure: a pair by every method, on the CPU and on the GPU.
#include <cmath>

#include "color/working_space.h"
#include "commands/command_test.h"

namespace metamer::test {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

class Measure : public CommandTest {
protected:
    json pair(const std::string& lamp, const std::string& material,
              const std::vector<std::string>& more = {}) const {
        std::vector<std::string> arguments = {"measure", "--lamp", lamp, "--material", material, "--json"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return json_of(arguments);
    }

    static std::vector<std::string> keys(const json& object) {
        std::vector<std::string> names;
        for (const auto& [key, value] : object.items())
            names.push_back(key);
        return names;
    }

    /// Three finite numbers (a number that is none would be written as null), and the twins at most one step
    /// apart.
    static void expect_sound(const json& document) {
        ASSERT_EQ(document["reference"]["xyz"].size(), 3u);
        for (const json& method : document["methods"]) {
            for (const json& number : method["xyz"])
                EXPECT_TRUE(number.is_number_float() && std::isfinite(number.get<double>())) << method;
            EXPECT_TRUE(method["delta_e_2000"].is_number_float()) << method;
            EXPECT_GE(method["delta_e_2000"].get<double>(), 0) << method;
            for (std::size_t i = 0; i < 3; ++i) {
                const int cpu = method["cpu_rgb8"][i].get<int>(), gpu = method["gpu_rgb8"][i].get<int>();
                EXPECT_LE(std::abs(cpu - gpu), 1) << method;
                EXPECT_TRUE(cpu >= 0 && cpu <= 255) << method;
            }
        }
    }
};

TEST_F(Measure, TheJsonIsTheContracts) {
    const json document = pair("F11", "crayon-red");
    EXPECT_THAT(keys(document), testing::UnorderedElementsAre("lamp", "material", "reference", "methods"));
    EXPECT_EQ(document["lamp"], "F11");
    EXPECT_EQ(document["material"], "crayon-red");
    EXPECT_THAT(keys(document["reference"]), ElementsAre("xyz"));
    const char* names[] = {"rgb", "tristimulus", "spectral", "prefiltered", "packed", "reduced", "folded"};
    ASSERT_EQ(document["methods"].size(), std::size(names));
    for (std::size_t i = 0; i < std::size(names); ++i) {
        EXPECT_EQ(document["methods"][i]["name"], names[i]);
        EXPECT_THAT(keys(document["methods"][i]),
                    testing::UnorderedElementsAre("name", "xyz", "delta_e_2000", "cpu_rgb8", "gpu_rgb8"));
    }
    expect_sound(document);
}

TEST_F(Measure, PairsOfEveryKindAreSound) {
    const std::pair<const char*, const char*> pairs[] = {
        {"E", "crayon-white"},         {"D65", "rgb:808080"},         {"krypton", "crayon-black"},
        {"line:589.3", "cc-blue"},     {"planck:2856", "crayon-red"}, {"daylight:5000", "gauss:530:20"},
        {"gauss:450:2", "single-450"}, {"F10", "weighted-600"},
    };
    for (const auto& [lamp, material] : pairs) {
        SCOPED_TRACE(std::string(lamp) + " on " + material);
        expect_sound(pair(lamp, material));
    }
}

// The thesis's identity: under equal energy both models agree, up to the grid's own white (its sums of x, y
// and z under E differ by less than a thousandth).
TEST_F(Measure, UnderEqualEnergyTristimulusIsSpectral) {
    for (const char* material : {"crayon-red", "cc-cyan", "single-550", "empirical-1"}) {
        const json methods = pair("E", material)["methods"];
        const json &tristimulus = methods[1], &spectral = methods[2];
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_NEAR(tristimulus["xyz"][i].get<double>(), spectral["xyz"][i].get<double>(), 1e-3)
                << material;
            EXPECT_NEAR(tristimulus["gpu_rgb8"][i].get<int>(), spectral["gpu_rgb8"][i].get<int>(), 1)
                << material;
        }
    }
    const json apart = pair("krypton", "crayon-orange")["methods"];
    EXPECT_GT(apart[1]["delta_e_2000"].get<double>(), 20 * apart[2]["delta_e_2000"].get<double>());
}

// The reference of the perfect reflector is the lamp's own white: CIE 15:2018 table 3 for D65, whose sums are
// in steps of 5 nm; 1 nm makes Z smaller by 2e-4.
TEST_F(Measure, ThePerfectReflectorIsTheLampsWhite) {
    write("white.csv", "wavelength_nm,white\n380,1\n780,1\n");
    const json d65 = pair("D65", "white.csv")["reference"]["xyz"];
    EXPECT_NEAR(d65[0].get<double>(), 0.95047, 1e-4);
    EXPECT_NEAR(d65[1].get<double>(), 1, 1e-12);
    EXPECT_NEAR(d65[2].get<double>(), 1.08883, 3e-4);
    const json methods = pair("D65", "white.csv")["methods"];
    EXPECT_THAT(methods[2]["gpu_rgb8"].get<std::vector<int>>(),
                testing::Pointwise(testing::Truly([](const auto& p) {
                                       return std::abs(std::get<0>(p) - std::get<1>(p)) <= 1;
                                   }),
                                   {255, 255, 255}));
}

TEST_F(Measure, SpectrumFilesAndTheirColumns) {
    write("lamp.csv", kFlatLamp);
    write("two.csv", kTwoMaterials);
    const json half = pair("lamp.csv", "two.csv#HALF");
    EXPECT_EQ(half["lamp"], "lamp.csv");
    EXPECT_EQ(half["material"], "two.csv#HALF");
    EXPECT_NEAR(half["reference"]["xyz"][1].get<double>(), 0.5, 1e-12);
    EXPECT_NEAR(half["methods"][2]["xyz"][1].get<double>(), 0.5, 1e-4) << "8 bits of the atlas";
    // The share of y beyond 550 nm within 400 .. 700 nm: a sum over ISO/CIE 11664-1, made apart.
    EXPECT_NEAR(pair("lamp.csv", "two.csv#step")["reference"]["xyz"][1].get<double>(), 0.58569, 1e-5);
    expect_failure(2, {"measure", "--lamp", "lamp.csv", "--material", "two.csv"},
                   "cannot read two.csv: it holds several spectra; add #COLUMN, one of half, step");
    expect_failure(2, {"measure", "--lamp", "lamp.csv", "--material", "two.csv#stop"},
                   "cannot read two.csv: it has no column `stop`, only half, step; did you mean \"step\"?");
}

TEST_F(Measure, LibraryNamesHaveNoCase) {
    const json document = pair("f11", "CRAYON-Red");
    EXPECT_EQ(document["lamp"], "F11");
    EXPECT_EQ(document["material"], "crayon-red");
}

TEST_F(Measure, TheTextShowsTheSameNumbers) {
    const json document = pair("F11", "crayon-red");
    const std::string text = output_of({"measure", "--lamp", "F11", "--material", "crayon-red"});
    EXPECT_THAT(text, testing::StartsWith("crayon-red on F11\n"));
    char line[128];
    for (const json& method : document["methods"]) {
        const json &xyz = method["xyz"], &cpu = method["cpu_rgb8"];
        std::snprintf(line, sizeof line, "%-12s %8.5f %8.5f %8.5f  %10.4f  %3d %3d %3d  ",
                      method["name"].get<std::string>().c_str(), xyz[0].get<double>(), xyz[1].get<double>(),
                      xyz[2].get<double>(), method["delta_e_2000"].get<double>(), cpu[0].get<int>(),
                      cpu[1].get<int>(), cpu[2].get<int>());
        EXPECT_THAT(text, HasSubstr(line));
    }
}

// Of an exhibit the display counts: in linear code values of Adobe RGB, the pixel is M xyz itself.
TEST_F(Measure, AnExhibitsDisplayCounts) {
    write("adobe.ini", "[display]\nworking_space = Adobe-D65\ntransfer = none\n[scene]\nkind = patches\n");
    const json document = pair("D65", "cc-green", {"--exhibit", "adobe.ini"});
    expect_sound(document);
    const json& spectral = document["methods"][2];
    const auto xyz = spectral["xyz"].get<std::array<double, 3>>();
    const auto rgb = rgb_from_xyz(*find_working_space("Adobe-D65")) * xyz;
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(spectral["gpu_rgb8"][i].get<int>(), 255 * std::clamp(rgb[i], 0.0, 1.0), 1) << i;
    EXPECT_EQ(document["reference"], pair("D65", "cc-green")["reference"]);
}

// JSON is UTF-8, and so must be what it names.
TEST_F(Measure, NamesAreUtf8) {
    write("caf\xe9.csv", kFlatLamp);
    expect_failure(2, {"measure", "--lamp", "caf\xe9.csv", "--material", "crayon-red", "--json"},
                   "cannot add lamp \"caf?.csv\": the name or its source is not UTF-8");
    write("caf\xc3\xa9.csv", kFlatLamp);
    EXPECT_EQ(pair("caf\xc3\xa9.csv", "crayon-red")["lamp"], "caf\xc3\xa9.csv");
}

TEST_F(Measure, WarningsLeaveTheJsonAlone) {
    write("wide.csv", "wavelength_nm,wide\n300,1\n1000,1\n");
    const Outcome outcome = metamer({"measure", "--lamp", "wide.csv", "--material", "crayon-red", "--json"});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_THAT(outcome.err, testing::StartsWith("metamer: warning: wide.csv: "));
    EXPECT_FALSE(json::parse(outcome.out, nullptr, false).is_discarded());
}

TEST_F(Measure, WhatCannotBeMeasured) {
    write("negative.csv", "wavelength_nm,lamp\n400,1\n500,-2\n700,1\n");
    const std::tuple<const char*, const char*, const char*> cases[] = {
        {"F1l", "crayon-red",
         "cannot find lamp \"F1l\": the library has no such lamp; did you mean \"F11\"?"},
        {"F11", "crayon-rd",
         "cannot find material \"crayon-rd\": the library has no such material; did you mean "
         "\"crayon-red\"?"},
        {"crayon-red", "crayon-red", "cannot find lamp \"crayon-red\": it is a material"},
        {"E", "E", "cannot find material \"E\": it is a lamp"},
        {"E", "crayons", "cannot find material \"crayons\": it is a set of materials"},
        {"none.csv", "crayon-red", "cannot read none.csv: there is no such file"},
        {"planck:0", "crayon-red", "cannot compute planck:0: temperature 0 K is outside 500..100000 K"},
        {"line:800", "crayon-red", "cannot use line:800: it has no light within 385..700 nm"},
        {"E", "line:589",
         "cannot compute line:589: a line has no width that a material could reflect; take "
         "gauss:CENTER:FWHM"},
    };
    for (const auto& [lamp, material, message] : cases)
        expect_failure(2, {"measure", "--lamp", lamp, "--material", material, "--json"}, message);
    expect_failure_like(2, {"measure", "--lamp", "negative.csv", "--material", "crayon-red"},
                        testing::StartsWith("metamer: cannot read negative.csv:3: "));
    expect_failure(2, {"measure", "--lamp", "E", "--material", "cc-red", "--exhibit", "none.ini"},
                   "cannot read none.ini: there is no such file");
}

} // namespace
} // namespace metamer::test
