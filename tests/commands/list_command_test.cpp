// metamer list: everything that has a name, and every name is taken where it belongs.
#include <sstream>

#include "commands/command_test.h"

namespace metamer::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class List : public CommandTest {
protected:
    /// The first word of every row until the first empty line.
    std::vector<std::string> names(const std::string& what) const {
        std::istringstream lines(output_of({"list", what}));
        std::vector<std::string> out;
        std::string line;
        while (std::getline(lines, line) && !line.empty()) {
            EXPECT_THAT(line, testing::ContainsRegex("^[^ ]+ +[^ ]")) << "a name and what it is";
            out.push_back(line.substr(0, line.find(' ')));
        }
        return out;
    }

    /// Set -> members, from `[set] description` and rows that are set in by two blanks.
    std::vector<std::pair<std::string, std::vector<std::string>>> sets() const {
        std::istringstream lines(output_of({"list", "materials"}));
        std::vector<std::pair<std::string, std::vector<std::string>>> out;
        for (std::string line; std::getline(lines, line);)
            if (line.starts_with('['))
                out.push_back({line.substr(1, line.find(']') - 1), {}});
            else if (line.starts_with("  "))
                out.back().second.push_back(line.substr(2, line.find(' ', 2) - 2));
        return out;
    }

    std::size_t rows_of(const std::string& atlas, const char* kind) const {
        std::size_t count = 0;
        const auto document = json_of({"atlas", "show", atlas, "--json"});
        for (const auto& row : document["rows"])
            count += row[kind].is_null() ? 0 : 1;
        return count;
    }
};

TEST_F(List, EveryLampIsFound) {
    const auto lamps = names("lamps");
    ASSERT_GE(lamps.size(), 50u);
    for (const char* lamp : {"E", "B", "C", "D65", "moonlight", "A2800", "F2", "F12", "white-LED", "krypton",
                             "A", "HP5", "LED-B1", "LED-V2"})
        EXPECT_THAT(lamps, testing::Contains(lamp));
    std::vector<std::string> arguments = {"atlas", "build", "-o", "a.png", "--lamps"};
    arguments.insert(arguments.end(), lamps.begin(), lamps.end());
    output_of(arguments);
    EXPECT_EQ(rows_of("a.png", "lamp"), lamps.size());
}

TEST_F(List, EveryMaterialIsFoundAndEverySetIsItsMembers) {
    const auto all = sets();
    ASSERT_EQ(all.size(), 6u);
    for (const auto& [set, members] : all) {
        std::vector<std::string> arguments = {"atlas", "build", "-o", "members.png", "--materials"};
        arguments.insert(arguments.end(), members.begin(), members.end());
        output_of(arguments);
        EXPECT_EQ(rows_of("members.png", "material"), members.size()) << set;
        output_of({"atlas", "build", "-o", "set.png", "--materials", set});
        EXPECT_EQ(read("set.png"), read("members.png")) << set;
    }
}

TEST_F(List, ModelledCrayonsSaySoEach) {
    std::istringstream lines(output_of({"list", "materials"}));
    int crayons = 0;
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("  crayon-")) {
            ++crayons;
            EXPECT_THAT(line, HasSubstr("modelled"));
        }
    EXPECT_EQ(crayons, 15);
}

TEST_F(List, SpacesMethodsAndScenesAreTakenByExhibits) {
    EXPECT_THAT(names("spaces"), ElementsAre("sRGB-D65", "sRGB-D50", "sRGB-E", "CIE-RGB-E", "Adobe-D65",
                                             "Apple-D50", "Apple-D65", "NTSC-C", "PAL-D65"));
    EXPECT_THAT(names("methods"),
                ElementsAre("rgb", "tristimulus", "spectral", "prefiltered", "packed", "reduced", "folded"));
    EXPECT_THAT(names("scenes"),
                ElementsAre("loaf", "crayons", "still-life", "ramp", "patches", "media", "corner", "booth"));
    std::vector<std::string> arguments = {"check"};
    const auto add = [&](const std::string& text) {
        const std::string name = std::to_string(arguments.size()) + ".ini";
        write(name, text);
        arguments.push_back(name);
    };
    for (const std::string& space : names("spaces"))
        add("[display]\nworking_space = " + space + "\n");
    for (const std::string& method : names("methods"))
        add("[accuracy]\nmethod = " + method + "\n");
    for (const std::string& scene : names("scenes"))
        add("[scene]\nkind = " + scene + "\n");
    output_of(arguments);
}

TEST_F(List, FormulasAndFilesAreSaid) {
    EXPECT_THAT(output_of({"list", "lamps"}),
                HasSubstr("\nBy formula: planck:KELVIN, daylight:KELVIN, gauss:CENTER_NM:FWHM_NM, line:NM. "
                          "By file: FILE.csv, FILE.csv#COLUMN\n"));
    EXPECT_THAT(output_of({"list", "materials"}),
                HasSubstr("\nBy formula: rgb:RRGGBB, gauss:CENTER_NM:FWHM_NM, "
                          "absorb:CENTER_NM:FWHM_NM:DENSITY... By file: FILE.csv, FILE.csv#COLUMN\n"));
}

} // namespace
} // namespace metamer::test
