#include "report/paper.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "image/error_of.h"
#include "report/picture.h"

namespace metamer {
namespace {

using testing::HasSubstr;

PaperRow row() {
    return {.gpu = "A, \"B\"",
            .method = "spectral",
            .straight = 36,
            .loop = 10,
            .rounds = 64,
            .clock_mhz = 0.9216,
            .instructions_per_clock = 676,
            .source = "a book; its page"};
}

constexpr const char* kHeader = "gpu,method,straight,loop,rounds,clock_mhz,instructions_per_clock,source\n";

// 1280 x 720 = 921600 pixels of 676 instructions each, 0.9216 MHz of 676: one frame a second.
TEST(Paper, FramesFollowFromTheRate) {
    EXPECT_EQ(row().instructions(), 676);
    EXPECT_DOUBLE_EQ(frames_per_s(row()), 1);
}

TEST(Paper, ReadsBackAsTheSame) {
    const Paper paper{{"nothing stalls", "Mesa", "2026-11-22", "scripts/paper"}, {row()}};
    EXPECT_EQ(read_paper_csv(paper_csv(paper), "p.csv"), paper);
}

TEST(Paper, JsonHasWhatFollows) {
    const auto json = nlohmann::json::parse(paper_json({{}, {row()}}));
    EXPECT_EQ(json["rows"][0]["instructions"], 676);
    EXPECT_DOUBLE_EQ(json["rows"][0]["frames_per_s"], 1);
}

TEST(Paper, SaysItsAssumptionOnThePicture) {
    const Picture picture = paper_picture({{.assumption = "nothing stalls", .compilers = "Mesa"}, {row()}});
    EXPECT_EQ(picture.plots.at(0).caption, "nothing stalls");
    EXPECT_EQ(picture.note, "Mesa");
    EXPECT_EQ(unplaced_labels(picture), 0);
}

TEST(Paper, RefusesWhatCannotBe) {
    const auto read = [](const std::string& line) { read_paper_csv(kHeader + line, "p.csv"); };
    EXPECT_EQ(error_of([&] { read("g,m,0,5,0,1,1,s\n"); }),
              "2: cannot read p.csv:2: a pixel without instructions");
    EXPECT_EQ(error_of([&] { read("g,m,1,0,0,1,1,s\ng,m,1,0,0,0,1,s\n"); }),
              "2: cannot read p.csv:3: clock_mhz and instructions_per_clock must be above 0");
    EXPECT_EQ(error_of([&] { read("g,m,-1,0,0,1,1,s\n"); }),
              "2: cannot read p.csv:2: straight = -1 is no number of at least 0");
    EXPECT_EQ(error_of([&] { read("g,m,1\n"); }), "2: cannot read p.csv:2: 3 cells under 8 columns");
    EXPECT_THAT(error_of([] { read_paper_csv("gpu,metod\n", "p.csv"); }),
                HasSubstr("p.csv:1: no column is named \"metod\"; did you mean \"method\"?"));
}

} // namespace
} // namespace metamer
