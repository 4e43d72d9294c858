// metamer chart: files of every kind, drawn again from a CSV, what is refused.
#include "commands/command_test.h"

namespace metamer::test {
namespace {

using testing::AllOf;
using testing::Each;
using testing::HasSubstr;
using testing::SizeIs;
using testing::StartsWith;

class ChartCommand : public CommandTest {
protected:
    ChartCommand() {
        write("show.ini", "[display]\nwidth = 16\nheight = 16\n[scene]\nkind = loaf\n"
                          "materials = crayon-red, two.csv#half\n[lamp.1]\nspectrum = F11\n");
        write("two.csv", kTwoMaterials);
    }

    std::string measured(const std::vector<std::string>& more) const {
        std::vector<std::string> arguments{"chart", "show.ini", "--rounds", "1"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return output_of(arguments);
    }

    static nlohmann::json row_of(const nlohmann::json& document, const std::string& method) {
        for (const auto& row : document["rows"])
            if (row["method"] == method)
                return row;
        ADD_FAILURE() << "no row of " << method;
        return {};
    }
};

TEST_F(ChartCommand, WritesEveryKindAndPrintsTheRows) {
    const std::string out = measured({"-o", "a.csv", "-o", "a.json", "-o", "a.svg", "--output", "a.png"});
    EXPECT_THAT(out,
                AllOf(StartsWith("show: 1 lamp × 2 materials, tolerance 0.5 CIEDE2000\n"),
                      HasSubstr("\nrgb-pow "), HasSubstr("\nplanned "), HasSubstr("a.png is written\n")));
    EXPECT_THAT(read("a.svg"), StartsWith("<?xml"));
    EXPECT_THAT(read("a.png"), StartsWith("\x89PNG"));
    EXPECT_THAT(read("a.csv"), StartsWith("# exhibit: show\n"));
    const auto document = nlohmann::json::parse(read("a.json"));
    EXPECT_EQ(document["context"]["command"], "metamer chart show.ini");
    EXPECT_EQ(document["context"]["width_px"], 16);
    EXPECT_EQ(row_of(document, "rgb-pow")["cost_ratio"], 1);
    EXPECT_TRUE(row_of(document, "folded")["chosen"].get<bool>());
    EXPECT_THAT(row_of(document, "planned")["delta_e_max"].get<double>(), testing::Lt(0.02));
}

TEST_F(ChartCommand, DrawsAgainFromItsCsv) {
    measured({"-o", "a.csv", "-o", "a.svg", "-o", "a.png", "-o", "a.json"});
    output_of({"chart", "--from", "a.csv", "-o", "b.csv", "-o", "b.svg", "-o", "b.png", "-o", "b.json"});
    for (const char* ending : {".csv", ".svg", ".png", ".json"})
        EXPECT_EQ(read(std::string("b") + ending), read(std::string("a") + ending)) << ending;
}

TEST_F(ChartCommand, TakesOtherLampsAndMaterials) {
    EXPECT_THAT(measured({"--lamps", "E", "--lamps", "krypton", "--materials", "two.csv", "-o", "a.csv"}),
                HasSubstr("2 lamps × 2 materials"));
}

TEST_F(ChartCommand, DrawsThePaperChart) {
    const std::string paper = "# assumption: nothing stalls\ngpu,method,straight,loop,rounds,clock_mhz,"
                              "instructions_per_clock,source\nG,spectral,36,10,64,0.9216,676,a book\n";
    write("p.csv", paper);
    EXPECT_THAT(output_of({"chart", "--paper", "p.csv", "-o", "p.svg", "-o", "p.json"}),
                AllOf(StartsWith("nothing stalls\n"), HasSubstr("676"), HasSubstr("1.0\n")));
    EXPECT_DOUBLE_EQ(nlohmann::json::parse(read("p.json"))["rows"][0]["frames_per_s"], 1);
    EXPECT_THAT(read("p.svg"), StartsWith("<?xml"));
}

TEST_F(ChartCommand, RefusesOutputsBeforeAnyWork) {
    expect_failure(2, {"chart", "-o", "a.pdf"},
                   "cannot write a.pdf: a chart ends in .svg, .png, .csv or .json");
    expect_failure(2, {"chart", "-o", "none/a.csv"}, "cannot write none/a.csv: there is no folder none");
    expect_failure(2, {"chart", "-o", ""}, "cannot write \"\": it names no file");
    expect_failure_like(2, {"chart"}, HasSubstr("--output"));
    expect_failure(2, {"chart", "-o", "a.csv", "none.ini"}, "cannot read none.ini: there is no such file");
}

TEST_F(ChartCommand, RefusesABrokenCsvAtItsLine) {
    write("bad.csv", "method,taps\nrgb,3\n");
    expect_failure_like(2, {"chart", "--from", "bad.csv", "-o", "a.svg"},
                        StartsWith("metamer: cannot read bad.csv:1: the column precision is missing"));
    measured({"-o", "a.csv"});
    std::string text = read("a.csv");
    const auto at = text.find("rgb-pow,0,");
    write("worse.csv", text.replace(at, 10, "rgb-pow,x,"));
    expect_failure_like(
        2, {"chart", "--from", "worse.csv", "-o", "b.svg"},
        testing::ContainsRegex("^metamer: cannot read worse.csv:[0-9]+: taps = x is no whole"));
    expect_failure_like(2, {"chart", "--growth", "--from", "a.csv", "-o", "b.svg"},
                        HasSubstr("no column is named \"taps\""));
    expect_failure_like(2, {"chart", "--paper", "none.csv", "-o", "b.svg"}, HasSubstr("none.csv"));
}

TEST_F(ChartCommand, RefusesWhatContradicts) {
    for (const std::vector<std::string>& more : {std::vector<std::string>{"--from", "a.csv", "--rounds", "3"},
                                                 {"--from", "a.csv", "show.ini"},
                                                 {"--paper", "a.csv", "--from", "a.csv"},
                                                 {"--paper", "a.csv", "--growth"},
                                                 {"--growth", "--lamps", "E"},
                                                 {"--rounds", "0"}}) {
        std::vector<std::string> arguments{"chart", "-o", "a.svg"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        expect_failure_like(2, arguments, StartsWith("metamer: cannot use the command line: "));
    }
    expect_failure_like(2, {"chart", "--lamps", "F99", "-o", "a.svg"}, HasSubstr("F99"));
}

TEST_F(ChartCommand, NeedsGlOnlyToMeasure) {
    const World blind{.environment = {{"__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent"}}};
    write("p.csv",
          "gpu,method,straight,loop,rounds,clock_mhz,instructions_per_clock,source\nG,rgb,1,0,0,1,1,s\n");
    EXPECT_EQ(metamer({"chart", "--paper", "p.csv", "-o", "p.svg"}, blind).status, 0);
    expect_failure_like(3, {"chart", "show.ini", "-o", "a.svg"},
                        HasSubstr("cannot open an OpenGL ES 2 context"), blind);
}

} // namespace
} // namespace metamer::test
