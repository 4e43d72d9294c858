// Names to spectra: the library, files, and what is said when there is none.
#include <filesystem>
#include <fstream>

#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "spectra/library.h"
#include "spectra/spectrum_file.h"

namespace metamer {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;

// A folder that goes with the test.
class Find : public testing::Test {
protected:
    void SetUp() override { fs::create_directories(folder); }
    void TearDown() override { fs::remove_all(folder); }

    void write(const std::string& name, const std::string& text) {
        fs::create_directories((folder / name).parent_path());
        std::ofstream(folder / name) << text;
    }

    std::string refusal(const std::string& name, bool lamp = true) {
        try {
            if (lamp)
                find_lamp(name, folder.string());
            else
                find_material(name, folder.string());
        } catch (const Error& error) {
            EXPECT_EQ(error.status(), Exit::bad_input);
            std::string text = error.what();
            for (std::size_t at; (at = text.find(folder.string() + "/")) != std::string::npos;)
                text.erase(at, folder.string().size() + 1);
            return text;
        }
        return "taken";
    }

    const fs::path folder = fs::path(testing::TempDir()) / ("metamer_find_" + std::to_string(::getpid()));
};

TEST_F(Find, TakesLibraryNamesWithoutCase) {
    EXPECT_EQ(find_lamp("f11").name, "F11");
    EXPECT_EQ(find_lamp(" LED-rgb1 ").name, "LED-RGB1");
    EXPECT_EQ(find_material("CRAYON-red").name, "crayon-red");
}

TEST_F(Find, OffersTheNearestName) {
    EXPECT_EQ(refusal("moonlihgt"),
              "cannot find lamp \"moonlihgt\": the library has no such lamp; did you mean \"moonlight\"?");
    EXPECT_EQ(refusal("crayon-ted", false), "cannot find material \"crayon-ted\": the library has no such "
                                            "material; did you mean \"crayon-red\"?");
    EXPECT_EQ(refusal("zzzzzzzz"), "cannot find lamp \"zzzzzzzz\": the library has no such lamp");
    EXPECT_EQ(refusal(""), "cannot find lamp \"\": the library has no such lamp");
    EXPECT_EQ(refusal("crayon-red"), "cannot find lamp \"crayon-red\": it is a material");
    EXPECT_EQ(refusal("F11", false), "cannot find material \"F11\": it is a lamp");
    EXPECT_EQ(refusal("crayons", false), "cannot find material \"crayons\": it is a set of materials");
}

TEST_F(Find, KnowsPathsFromNames) {
    for (const char* path : {"a.csv", "A.CSV", "a.txt", "x/y", "./D65", "a.csv#tube", "a.csv#x/y"})
        EXPECT_TRUE(names_file(path)) << path;
    for (const char* name : {"D65", "planck:2856", "csv", "a.csvx"})
        EXPECT_FALSE(names_file(name)) << name;
}

TEST_F(Find, KnowsThePathInAName) {
    EXPECT_EQ(path_named("a.csv#tube"), "a.csv");
    EXPECT_EQ(path_named("a#1.csv#x/y"), "a#1.csv");
    EXPECT_EQ(path_named("x/y"), "x/y");
    EXPECT_EQ(path_named("planck:2856"), "");
}

TEST_F(Find, ReadsFilesFromTheFolder) {
    write("sub/lamp.csv", "# A tube\n# source: a bench\nnm,tube\n400,1\n700,1\n");
    const Lamp lamp = find_lamp("sub/lamp.csv", folder.string());
    EXPECT_EQ(lamp.name, "sub/lamp.csv");
    EXPECT_EQ(lamp.description, "tube: A tube");
    EXPECT_EQ(lamp.source, "a bench");
    EXPECT_THAT(lamp.spectrum.continuum.value, ElementsAre(1, 1));
    const fs::path absolute = folder / "sub/lamp.csv";
    EXPECT_THAT(find_lamp(absolute.string(), "/nowhere").spectrum.continuum.value, ElementsAre(1, 1));
}

TEST_F(Find, PicksTheColumn) {
    write("two.csv", "nm,cold,warm\n400,1,2\n700,1,2\n");
    EXPECT_THAT(find_lamp("two.csv#Warm", folder.string()).spectrum.continuum.value, ElementsAre(2, 2));
    EXPECT_EQ(find_lamp("two.csv#Warm", folder.string()).name, "two.csv#Warm");
    EXPECT_EQ(refusal("two.csv"),
              "cannot read two.csv: it holds several spectra; add #COLUMN, one of cold, warm");
    EXPECT_EQ(refusal("two.csv#wram"),
              "cannot read two.csv: it has no column `wram`, only cold, warm; did you mean \"warm\"?");
    write("odd#name.csv", "nm,a\n400,0.5\n700,0.5\n");
    EXPECT_THAT(find_material("odd#name.csv", folder.string()).spectrum.curve.value, ElementsAre(0.5, 0.5));
    EXPECT_THAT(find_material("odd#name.csv#a", folder.string()).spectrum.curve.value, ElementsAre(0.5, 0.5));
}

TEST_F(Find, TellsWhatIsWrongAndWhere) {
    EXPECT_EQ(refusal("none.csv"), "cannot read none.csv: there is no such file");
    EXPECT_EQ(refusal("./none"), "cannot read none: there is no such file");
    write("bad.csv", "nm,a\n400,1\n390,1\n");
    EXPECT_EQ(refusal("bad.csv"),
              "cannot read bad.csv:3: wavelength 390 comes after a longer one; they must ascend");
    write("bright.csv", "nm,a\n400,0.5\n410,1.5\n");
    EXPECT_EQ(refusal("bright.csv", false), "cannot read bright.csv:3: reflectance 1.5 is above 1: "
                                            "fluorescence is not taken, percent must be named "
                                            "(`# unit: percent`)");
}

TEST_F(Find, RefusesLampsWithoutLightOnTheGrid) {
    write("dark.csv", "nm,a\n400,0\n700,0\n");
    EXPECT_EQ(refusal("dark.csv"), "cannot use dark.csv: it has no light within 385..700 nm");
    write("heat.csv", "nm,a\n800,1\n1000,1\n");
    EXPECT_EQ(refusal("heat.csv"), "cannot use heat.csv: it has no light within 385..700 nm");
    write("faint.csv", "nm,a\n400,1e-300\n700,1e-300\n");
    EXPECT_EQ(refusal("faint.csv"), "cannot use faint.csv: it has no light within 385..700 nm");
}

TEST_F(Find, WarnsOfEnergyOutsideTheGrid) {
    std::vector<std::string> warnings;
    write("inside.csv", "nm,a\n400,0\n500,1\n600,0\n");
    find_lamp("inside.csv", folder.string(), &warnings);
    EXPECT_THAT(warnings, IsEmpty());
    // 700 nm in all; 385 .. 700 nm and half a hat on both sides of it are kept.
    write("wide.csv", "nm,a\n300,1\n1000,1\n");
    find_lamp("wide.csv", folder.string(), &warnings);
    EXPECT_THAT(
        warnings,
        ElementsAre("wide.csv: 54.6 % of its energy lies outside the grid (385..700 nm) and is lost"));
    warnings.clear();
    find_lamp("planck:2856", ".", &warnings);
    EXPECT_THAT(warnings, IsEmpty()) << "formulas and the library are what they are";
    find_lamp("wide.csv", folder.string()); // nobody listens
}

TEST_F(Find, WarnsOfMaterialsThatLeaveOutPartOfTheGrid) {
    std::vector<std::string> warnings;
    write("short.csv", "nm,a\n450,0.5\n650,0.5\n");
    find_material("short.csv", folder.string(), &warnings);
    EXPECT_THAT(warnings,
                ElementsAre("short.csv: it covers 450..650 nm only; its end values are held beyond"));
    warnings.clear();
    write("red.csv", "nm,a\n450,0.5\n700,0.5\n");
    find_material("red.csv", folder.string(), &warnings);
    write("blue.csv", "nm,a\n400,0.5\n650,0.5\n");
    find_material("blue.csv", folder.string(), &warnings);
    EXPECT_THAT(warnings, ElementsAre(testing::HasSubstr("450..700"), testing::HasSubstr("400..650")));
    warnings.clear();
    write("full.csv", "nm,a\n400,0.5\n700,0.5\n");
    find_material("full.csv", folder.string(), &warnings);
    EXPECT_THAT(warnings, IsEmpty());
}

} // namespace
} // namespace metamer
