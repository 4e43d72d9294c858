// metamer stability: the table, the document, the files, and what is refused. One run takes seconds; each of
// these is one.
#include <algorithm>
#include <set>

#include "commands/command_test.h"
#include "image/png.h"

namespace metamer::test {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;

using StabilityCommand = CommandTest;

TEST_F(StabilityCommand, PrintsATable) {
    const std::string text = output_of({"stability"});
    EXPECT_THAT(text,
                StartsWith("Where each method fails: its CIEDE2000 against the reference exceeds 1.\n"));
    for (const char* part : {"\nWidth of a lamp's band: ", " fails at ", "holds throughout: ", "guard: "})
        EXPECT_THAT(text, HasSubstr(part));
    EXPECT_TRUE(files().empty());
}

TEST_F(StabilityCommand, WritesPagesAndCurvesAndPrintsTheContractsDocument) {
    const nlohmann::json document = json_of({"stability", "--json", "--output", "pages"});
    const nlohmann::json& experiments = document.at("experiments");
    EXPECT_EQ(experiments.size(), 21u);
    for (const auto& e : experiments) {
        for (const char* key : {"name", "swept", "unit", "guard"})
            EXPECT_TRUE(e.at(key).is_string()) << key;
        for (const auto& point : e.at("points")) {
            EXPECT_TRUE(point.at("x").is_number());
            ASSERT_FALSE(point.at("delta_e").empty());
            for (const auto& difference : point.at("delta_e"))
                EXPECT_TRUE(difference.is_number()) << e.at("name");
        }
        for (const auto& fail : e.at("fails")) {
            EXPECT_TRUE(fail.at("method").is_string());
            EXPECT_TRUE(fail.at("at").is_number());
            EXPECT_TRUE(fail.at("why").is_string());
            EXPECT_TRUE(e.at("points").at(0).at("delta_e").contains(fail.at("method"))) << e.at("name");
        }
    }
    std::vector<std::string> written = files();
    EXPECT_THAT(written, AllOf(Contains("pages/stability.csv"), Contains("pages/stability-narrow-light.svg"),
                               Contains("pages/stability-narrow-light.png")));
    std::set<std::string> groups;
    for (const auto& e : experiments)
        groups.insert(e.at("group").get<std::string>());
    EXPECT_EQ(written.size(), 2 + 2 * groups.size()) << "the folder, the CSV, and a page per group, twice";
    for (const std::string& name : written) {
        if (name.ends_with(".svg")) {
            EXPECT_THAT(read(name), AllOf(StartsWith("<?xml"), EndsWith("</svg>\n"))) << name;
        }
        if (name.ends_with(".png")) {
            EXPECT_GT(decode_png(read(name), name).image.width, 1000) << name;
        }
    }
    EXPECT_THAT(read("pages/stability.csv"),
                StartsWith("experiment,swept,unit,x,point,method,delta_e_2000\n"));
}

TEST_F(StabilityCommand, RefusesFoldersThatCannotBe) {
    write("file", "x");
    expect_failure(2, {"stability", "--output", "file"}, "cannot write file: it is no folder");
    expect_failure(2, {"stability", "--output", ""}, "cannot write \"\": it names no folder");
    expect_failure(2, {"stability", "--output", "no/such"},
                   "cannot write no/such: no folder can be made there: No such file or directory");
    EXPECT_EQ(read("file"), "x");
}

TEST_F(StabilityCommand, AFullDiskLeavesNoHalfFile) {
    fs::create_directory(folder_ / "pages");
    expect_failure_like(1, {"stability", "--output", "pages"},
                        AllOf(StartsWith("metamer: cannot write pages/stability.csv: "), EndsWith("\n")),
                        {.most_file_bytes = 1000});
}

} // namespace
} // namespace metamer::test
