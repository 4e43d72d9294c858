// The CSV reader: what it takes, and what it says of what it does not.
#include "spectra/csv.h"

#include <filesystem>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"

namespace metamer {
namespace {

using testing::ElementsAre;

SpectrumTable lamp(const std::string& text) {
    return parse_spectra(text, "f.csv", SpectrumKind::emission);
}

SpectrumTable material(const std::string& text) {
    return parse_spectra(text, "f.csv", SpectrumKind::reflectance);
}

std::string refusal(const std::string& text, SpectrumKind kind = SpectrumKind::emission) {
    try {
        parse_spectra(text, "f.csv", kind);
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), Exit::bad_input);
        return error.what();
    }
    return "taken";
}

std::string material_refusal(const std::string& text) {
    return refusal(text, SpectrumKind::reflectance);
}

TEST(Csv, ReadsCommentsHeaderAndRows) {
    const SpectrumTable table = lamp("# Two tubes\n# source: a bench\n# unit: W/(m2 nm)\n# Another remark\n"
                                     "wavelength_nm,cold,warm\n400,1,0.5\n410.5,2,0\n");
    EXPECT_EQ(table.title, "Two tubes");
    EXPECT_EQ(table.source, "a bench");
    EXPECT_EQ(table.unit, "W/(m2 nm)");
    EXPECT_THAT(table.names, ElementsAre("cold", "warm"));
    EXPECT_THAT(table.curves[0].wavelength_nm, ElementsAre(400, 410.5));
    EXPECT_THAT(table.curves[0].value, ElementsAre(1, 2));
    EXPECT_THAT(table.curves[1].wavelength_nm, ElementsAre(400, 410.5));
    EXPECT_THAT(table.curves[1].value, ElementsAre(0.5, 0));
}

TEST(Csv, TakesByteOrderMarkLineEndsBlankLinesAndNoLastNewline) {
    const SpectrumTable crlf = lamp("\xEF\xBB\xBF# T\r\n\r\nwavelength_nm , a\r\n 400 , 1e0 \r\n\r\n410,2");
    EXPECT_EQ(crlf.title, "T");
    EXPECT_THAT(crlf.names, ElementsAre("a"));
    EXPECT_THAT(crlf.curves[0].value, ElementsAre(1, 2));
    EXPECT_THAT(lamp("nm,a\r400,3\r410,4\r").curves[0].value, ElementsAre(3, 4));
}

TEST(Csv, CountsLinesInEveryLineEnd) {
    for (const std::string end : {"\n", "\r\n", "\r"})
        EXPECT_EQ(refusal("# T" + end + end + "nm,a" + end + "400,x" + end),
                  "cannot read f.csv:4: column 2 is no number: `x`");
}

TEST(Csv, TakesQuotedNames) {
    EXPECT_THAT(lamp("\"wavelength_nm\",\"a, \"\"b\"\"\" , c\n400,\"1\",2\n410,1,2\n").names,
                ElementsAre("a, \"b\"", "c"));
}

// Found by scripts/fuzz: `f.csv# a ` could not ask for a column whose name began with a blank.
TEST(Csv, TakesBlanksOffQuotedNames) {
    EXPECT_THAT(lamp("nm,\" a \",b\n400,1,2\n500,3,4\n").names, ElementsAre("a", "b"));
    EXPECT_EQ(refusal("nm,\" \"\n400,1\n500,3\n"), "cannot read f.csv:1: column 2 has no name");
    EXPECT_EQ(refusal("nm,\"a \",a\n400,1,2\n500,3,4\n"), "cannot read f.csv:1: two columns are named `a`");
}

TEST(Csv, NamesTwoColumnsWithoutHeaderByTheFile) {
    const SpectrumTable table = parse_spectra("400,1\n410,2\n", "some/my lamp.csv", SpectrumKind::emission);
    EXPECT_THAT(table.names, ElementsAre("my lamp"));
    EXPECT_THAT(table.curves[0].value, ElementsAre(1, 2));
}

TEST(Csv, ConvertsMicrometersAngstromsAndPercent) {
    for (const char* header : {"wavelength_um", "\xC2\xB5m", "lambda (micrometers)"})
        EXPECT_THAT(lamp(std::string(header) + ",a\n0.5,1\n0.75,2\n").curves[0].wavelength_nm,
                    ElementsAre(500, 750));
    EXPECT_THAT(lamp("wavelength_angstrom,a\n4000,1\n5000,2\n").curves[0].wavelength_nm,
                ElementsAre(400, 500));
    EXPECT_THAT(material("# unit: percent\nnm,a\n400,50\n410,100\n").curves[0].value, ElementsAre(0.5, 1));
    EXPECT_THAT(material("# unit: %\nnm,a\n400,50\n410,100\n").curves[0].value, ElementsAre(0.5, 1));
}

TEST(Csv, TakesReflectancesAHairAboveOneAsOne) {
    EXPECT_THAT(material("nm,a\n400,1.0000005\n410,1\n").curves[0].value, ElementsAre(1, 1));
}

TEST(Csv, TakesNegativeComponents) {
    EXPECT_THAT(parse_spectra("nm,S1\n400,-1\n410,2\n", "f.csv", SpectrumKind::component).curves[0].value,
                ElementsAre(-1, 2));
}

TEST(Csv, RefusesEmptyFiles) {
    EXPECT_EQ(refusal(""), "cannot read f.csv: it is empty");
    EXPECT_EQ(refusal("\xEF\xBB\xBF\r\n \n"), "cannot read f.csv: it is empty");
    EXPECT_EQ(refusal("# only\n# remarks\n"), "cannot read f.csv: it has comments only, no rows");
    EXPECT_EQ(refusal("nm,a\n"), "cannot read f.csv: it has no point; a spectrum needs at least two");
    EXPECT_EQ(refusal("nm,a\n400,1\n"),
              "cannot read f.csv: it has one point only; a spectrum needs at least two");
}

TEST(Csv, RefusesWhatIsNoText) {
    EXPECT_EQ(refusal(std::string("nm,a\n40\0,1\n", 11)), "cannot read f.csv: it is no text file");
    EXPECT_EQ(refusal("\xFF\xFEn"), "cannot read f.csv: it is UTF-16; save it as UTF-8");
    EXPECT_EQ(refusal("nm,\"a\n400,1\n410,2\n"), "cannot read f.csv:1: a double quote is not closed");
}

TEST(Csv, RefusesNegativeValues) {
    EXPECT_EQ(refusal("nm,a\n400,1\n410,-0.5\n"), "cannot read f.csv:3: value -0.5 is negative");
}

TEST(Csv, RefusesWhatIsNotFinite) {
    EXPECT_EQ(refusal("nm,a\n400,nan\n"), "cannot read f.csv:2: column 2 is `nan`; values must be finite");
    EXPECT_EQ(refusal("nm,a\n400,-Inf\n"), "cannot read f.csv:2: column 2 is `-Inf`; values must be finite");
    EXPECT_EQ(refusal("nm,a\nNaN,1\n"), "cannot read f.csv:2: column 1 is `NaN`; values must be finite");
    EXPECT_EQ(refusal("nm,a\n400,1e31\n"), "cannot read f.csv:2: value 1e+31 is beyond 1e30");
}

TEST(Csv, RefusesUnsortedAndRepeatedWavelengths) {
    EXPECT_EQ(refusal("nm,a\n400,1\n410,1\n405,1\n"),
              "cannot read f.csv:4: wavelength 405 comes after a longer one; they must ascend");
    EXPECT_EQ(refusal("nm,a\n400,1\n400.0,1\n"), "cannot read f.csv:3: wavelength 400.0 is repeated");
}

TEST(Csv, RefusesWrongSeparators) {
    const std::string rule = "; the separator must be a comma, the decimal mark a point";
    EXPECT_EQ(refusal("nm;a\n400;1\n"), "cannot read f.csv:1: cells are separated by `;`" + rule);
    EXPECT_EQ(refusal("400,5;0,25\n"), "cannot read f.csv:1: cells are separated by `;`" + rule);
    EXPECT_EQ(refusal("nm\ta\n400\t1\n"), "cannot read f.csv:1: cells are separated by tabs" + rule);
    EXPECT_EQ(refusal("# T\n400 1\n410 1\n"), "cannot read f.csv:2: cells are separated by blanks" + rule);
    EXPECT_EQ(
        refusal("400\n410\n"),
        "cannot read f.csv:1: there is one column only; a spectrum has a wavelength and at least one value");
}

TEST(Csv, RefusesDecimalCommas) {
    EXPECT_EQ(refusal("nm,a\n400,0,5\n"),
              "cannot read f.csv:2: there are 3 cells where 2 are wanted (a decimal comma?)");
    EXPECT_EQ(refusal("nm,a\n400,\"0,5\"\n"),
              "cannot read f.csv:2: column 2 has a decimal comma (`0,5`); the mark is a point");
}

TEST(Csv, RefusesRaggedRows) {
    EXPECT_EQ(refusal("nm,a,b\n400,1\n"), "cannot read f.csv:2: there are 2 cells where 3 are wanted");
    EXPECT_EQ(refusal("nm,a,b\n400,1,\n"), "cannot read f.csv:2: column 3 is empty");
    EXPECT_EQ(refusal("nm,a\n400,1x\n"), "cannot read f.csv:2: column 2 is no number: `1x`");
}

TEST(Csv, RefusesHeadersThatLeaveThingsOpen) {
    EXPECT_EQ(refusal("400,1,2\n410,1,2\n"),
              "cannot read f.csv:1: there is no header; more than two columns need wavelength_nm,NAME,...");
    EXPECT_EQ(refusal("time,a\n400,1\n"),
              "cannot read f.csv:1: the header must begin with wavelength_nm, not `time`");
    EXPECT_EQ(refusal("nm,a,\n400,1,2\n"), "cannot read f.csv:1: column 3 has no name");
    EXPECT_EQ(refusal("nm,a,A\n400,1,2\n"), "cannot read f.csv:1: two columns are named `A`");
}

TEST(Csv, RefusesWavelengthsThatCannotBeNanometers) {
    EXPECT_EQ(
        refusal("nm,a\n0.4,1\n0.7,1\n"),
        "cannot read f.csv:2: wavelength 0.4 cannot be nanometers (100..5000 nm); for micrometers call the "
        "column wavelength_um");
    EXPECT_EQ(refusal("nm,a\n4000,1\n7000,1\n"), "cannot read f.csv:3: wavelength 7000 cannot be nanometers "
                                                 "(100..5000 nm); for angstroms call the column "
                                                 "wavelength_angstrom");
    EXPECT_EQ(refusal("nm,a\n-400,1\n"),
              "cannot read f.csv:2: wavelength -400 cannot be nanometers (100..5000 nm)");
    EXPECT_EQ(refusal("wavelength_um,a\n400,1\n"),
              "cannot read f.csv:2: wavelength 400 is not in range (100..5000 nm)");
}

TEST(Csv, RefusesUnitsThatCannotBe) {
    EXPECT_EQ(refusal("wavenumber_cm-1,a\n14000,1\n"),
              "cannot read f.csv: its unit names `cm-1`; convert it to nm and power per nm");
    EXPECT_EQ(refusal("# unit: W per THz\nnm,a\n400,1\n"),
              "cannot read f.csv: its unit names `thz`; convert it to nm and power per nm");
    EXPECT_EQ(
        refusal("# unit: W/(m2 um)\nwavelength,a\n400,1\n"),
        "cannot read f.csv: `# unit:` names `um`, the header no unit; call the first column wavelength_nm, "
        "wavelength_um or wavelength_angstrom");
    EXPECT_EQ(refusal("# unit: umol/(m2 s nm)\nnm,a\n400,1\n"),
              "cannot read f.csv: its unit counts photons (`umol`); divide by the wavelength for power");
    EXPECT_EQ(refusal("# unit: reflectance factor\nnm,a\n400,1\n"),
              "cannot read f.csv: its unit is that of a material (`reflectance`), not of a lamp");
    EXPECT_EQ(material_refusal("# unit: W/nm\nnm,a\n400,1\n"),
              "cannot read f.csv: its unit cannot be a reflectance (`w`)");
}

TEST(Csv, TakesAUnitPerMicrometerUnderAHeaderOfNanometers) {
    EXPECT_THAT(lamp("# unit: W/(m2 um)\nwavelength_nm,a\n400,1\n410,2\n").curves[0].wavelength_nm,
                ElementsAre(400, 410));
}

TEST(Csv, RefusesReflectancesAboveOne) {
    EXPECT_EQ(
        material_refusal("nm,a\n400,0.5\n410,1.2\n"),
        "cannot read f.csv:3: reflectance 1.2 is above 1: fluorescence is not taken, percent must be named "
        "(`# unit: percent`)");
    EXPECT_EQ(material_refusal("# unit: percent\nnm,a\n400,50\n410,101\n"),
              "cannot read f.csv:4: reflectance 101 is above 100 percent: fluorescence is not taken");
    EXPECT_EQ(material_refusal("nm,a\n400,-0.1\n"), "cannot read f.csv:2: value -0.1 is negative");
}

TEST(Csv, ReadsFilesOnly) {
    EXPECT_THROW(read_spectra("no/such.csv", SpectrumKind::emission), Error);
    const auto path = std::filesystem::path(testing::TempDir()) / "metamer_csv_test.csv";
    std::ofstream(path) << "nm,a\n400,1\n410,2\n";
    EXPECT_THAT(read_spectra(path.string(), SpectrumKind::emission).curves[0].value, ElementsAre(1, 2));
    std::filesystem::remove(path);
}

// Every prefix and every flipped byte of a good file is either taken or refused in a sentence.
TEST(Csv, SurvivesDamage) {
    const std::string good = "# T\n# unit: W/nm\nwavelength_nm,\"a\",b\n400,1,2\n410,1e-3,4\n420,5,6\n";
    const auto tried = [](const std::string& text) {
        const std::string said = refusal(text);
        EXPECT_TRUE(said == "taken" || said.starts_with("cannot read f.csv")) << said;
    };
    for (std::size_t n = 0; n < good.size(); ++n) {
        tried(good.substr(0, n));
        for (const char c : {'\0', ',', '\n', '"', '\xFF', '-', ';'}) {
            std::string damaged = good;
            damaged[n] = c;
            tried(damaged);
        }
    }
}

} // namespace
} // namespace metamer
