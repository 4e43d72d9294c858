// What the rows become: the plots of the charts, before they are drawn.
#include "report/chart_picture.h"

#include <cmath>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <set>

#include "image/error_of.h"
#include "report/experiment.h"
#include "report/picture.h"
#include "report/samples.h"

namespace metamer {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const Series* find(const Plot& plot, const std::string& label) {
    for (const Series& series : plot.series)
        if (series.label == label)
            return &series;
    return nullptr;
}

std::size_t bars(const Plot& plot) {
    std::size_t count = 0;
    for (const Series& series : plot.series)
        for (const PlotPoint& point : series.points)
            count += point.y_spread.has_value();
    return count;
}

TEST(ChartPicture, ShowsEveryRowOnce) {
    const Chart chart = sample_chart();
    EXPECT_EQ(bars(chart_picture(chart).plots.at(0)), chart.rows.size());
}

TEST(ChartPicture, NamesEachMethodAndItsWorstPair) {
    const Plot plot = chart_picture(sample_chart()).plots.at(0);
    ASSERT_TRUE(find(plot, "spectral 64"));
    EXPECT_EQ(find(plot, "spectral 64")->second_line, "worst 2.15: crayon-black under F10");
    ASSERT_TRUE(find(plot, "reduced, N ="));
    EXPECT_EQ(find(plot, "reduced, N =")->second_line, "worst 15 (N = 4): ces-16 violet under krypton");
    EXPECT_EQ(find(plot, "reduced, N =")->points.size(), 7u);
    EXPECT_EQ(find(plot, "reduced, N =")->points[3].label, "12");
    for (const char* method : {"rgb", "tristimulus", "prefiltered", "packed 64", "folded"})
        EXPECT_TRUE(find(plot, method)) << method;
}

TEST(ChartPicture, SortsByTapsWhateverTheOrder) {
    Chart chart = sample_chart();
    std::reverse(chart.rows.begin(), chart.rows.end());
    const Plot plot = chart_picture(chart).plots.at(0);
    const Series* reduced = find(plot, "reduced, N =");
    ASSERT_TRUE(reduced);
    EXPECT_EQ(reduced->points.front().label, "4");
    EXPECT_EQ(reduced->points.back().label, "32");
    EXPECT_FALSE(reduced->hollow) << "the method's name stands at fp32";
    EXPECT_EQ(reduced->marker, Marker::disc) << "and at the 8-bit atlas";
}

TEST(ChartPicture, BarsReachFromTheMeanToTheWorst) {
    Chart chart;
    chart.rows = {sample_row("rgb", 0, Precision::fp32, Levels::eight_bit, 1, 4.8, 15, 58, "m", "l")};
    const Series series = chart_picture(chart).plots.at(0).series.at(1);
    ASSERT_TRUE(series.points.at(0).y_spread);
    EXPECT_EQ(series.points[0].y, 4.8);
    EXPECT_EQ(series.points[0].y_spread->high, 58);
    EXPECT_EQ(series.points[0].y_spread->tick, 15);
}

TEST(ChartPicture, DrawsTheFrontierByItsAccuracy) {
    Chart chart = sample_chart();
    for (const FrontierBy by : {FrontierBy::mean, FrontierBy::max}) {
        chart.context.frontier_by = by;
        mark_frontier(chart.rows, by);
        std::size_t marked = 0;
        for (const ChartRow& row : chart.rows)
            marked += row.on_frontier;
        const Series frontier = chart_picture(chart).plots.at(0).series.at(0);
        ASSERT_EQ(frontier.stroke, Stroke::steps);
        EXPECT_EQ(frontier.points.size(), marked);
        for (std::size_t i = 1; i < frontier.points.size(); ++i) {
            EXPECT_LT(frontier.points[i - 1].x, frontier.points[i].x);
            EXPECT_GT(frontier.points[i - 1].y, frontier.points[i].y);
        }
    }
}

TEST(ChartPicture, RingsThePlannersChoice) {
    const Plot plot = chart_picture(sample_chart()).plots.at(0);
    ASSERT_EQ(plot.marks.size(), 1u);
    EXPECT_EQ(plot.marks[0].word, "planner's choice");
    EXPECT_EQ(plot.marks[0].x, 0.65);
}

TEST(ChartPicture, SaysWhereAndWhen) {
    EXPECT_EQ(
        chart_picture(sample_chart()).note,
        "llvmpipe (LLVM 15.0.6, 256 bits) · 1280x720 · 2026-11-22 · metamer chart config/still-life.ini");
    EXPECT_THAT(chart_picture(sample_chart()).subtitle, HasSubstr("45 lamps × 64 materials"));
    EXPECT_EQ(chart_picture({}).note, "");
}

TEST(ChartPicture, ComesTheSameFromItsCsv) {
    const Chart chart = sample_chart();
    EXPECT_EQ(picture_svg(chart_picture(read_chart_csv(chart_csv(chart), "a.csv"))),
              picture_svg(chart_picture(chart)));
}

// At both sizes of the contract every name of a method, line and mark has its place.
TEST(ChartPicture, FindsRoomForItsLabels) {
    EXPECT_EQ(unplaced_labels(chart_picture(sample_chart(), 1600, 1000)), 0);
    EXPECT_EQ(unplaced_labels(chart_picture(sample_chart(), 1200, 800)), 0);
}

TEST(ChartPicture, CountsLabelsWithoutRoom) {
    Chart chart;
    for (int i = 0; i < 400; ++i)
        chart.rows.push_back(sample_row("method-" + std::to_string(i), 64, Precision::fp32, Levels::eight_bit,
                                        1 + i % 20, 1 + i / 20, 40, 50, "material", "lamp"));
    EXPECT_GT(unplaced_labels(chart_picture(chart, 640, 480)), 0);
}

TEST(CostPicture, SharesOneCostAxis) {
    const Picture picture = cost_picture(sample_costs(), sample_chart().context);
    ASSERT_EQ(picture.plots.size(), 4u);
    for (const Plot& plot : picture.plots) {
        EXPECT_EQ(plot.series.size(), 6u);
        EXPECT_EQ(plot.y.low, picture.plots[0].y.low);
        EXPECT_EQ(plot.y.high, picture.plots[0].y.high);
        ASSERT_TRUE(plot.y.low && plot.y.high);
        for (const Series& series : plot.series)
            for (const PlotPoint& point : series.points) {
                EXPECT_GE(point.y, *plot.y.low);
                EXPECT_LE(point.y, *plot.y.high);
            }
    }
    EXPECT_EQ(unplaced_labels(picture), 0);
    EXPECT_EQ(error_of([] { picture_svg(cost_picture({}, {})); }), "no error");
}

TEST(RatePicture, HasALevelPerGpu) {
    const Picture picture = rate_picture(sample_rates(), "assumption", "note");
    const Plot& plot = picture.plots.at(0);
    EXPECT_THAT(plot.y.categories, ElementsAre("Mali-450", "VideoCore IV", "Vivante GC2000", "Adreno 200"));
    EXPECT_EQ(plot.series.size(), 28u);
    EXPECT_EQ(plot.series[7].points[0].y, 1);
    EXPECT_EQ(plot.lines[0].value, 60);
    EXPECT_EQ(plot.caption, "assumption");
    EXPECT_EQ(unplaced_labels(picture), 0);
}

TEST(ExperimentPages, FillPageAfterPage) {
    const auto pages = experiment_pages(sample_experiments(), 0.5, "note", 3, 2);
    ASSERT_EQ(pages.size(), 2u);
    EXPECT_EQ(pages[0].plots.size(), 6u);
    EXPECT_EQ(pages[1].plots.size(), 2u);
    EXPECT_THAT(pages[1].title, HasSubstr("2 of 2"));
    EXPECT_TRUE(experiment_pages({}, 0.5, "", 3, 2).empty());
    EXPECT_EQ(error_of([] { experiment_pages({}, 0, "", 0, 2); }),
              "2: cannot draw stability: pages have at least one column and one row");
    for (const Picture& page : pages)
        EXPECT_EQ(unplaced_labels(page), 0);
}

TEST(ExperimentPages, MarkTheFailureOnTheLine) {
    Experiment e{.name = "n", .swept = "s", .unit = "nm", .guard = "g"};
    e.points = {{1, {{"spectral", 100}}}, {100, {{"spectral", 1}}}};
    e.fails = {{"spectral", 10, "w"},
               {"packed", 10, "not measured"},
               {"spectral", 1000, "beyond"},
               {"spectral", 100, "at"}};
    const Plot plot = experiment_pages({e}, 0, "").at(0).plots.at(0);
    ASSERT_EQ(plot.marks.size(), 4u);
    EXPECT_NEAR(plot.marks[0].y, 10, 1e-9); // half way on both logarithms
    EXPECT_TRUE(std::isnan(plot.marks[1].y));
    EXPECT_EQ(plot.marks[2].y, 1);
    EXPECT_EQ(plot.marks[3].y, 1);
    EXPECT_EQ(plot.marks[0].word, "10 nm");
    EXPECT_THAT(plot.caption, HasSubstr("spectral: w. "));
    EXPECT_THAT(plot.caption, HasSubstr("Guard: g"));
    EXPECT_EQ(plot.x.title, "s, nm");
}

TEST(ExperimentPages, SayTheFindingAndEachCauseOnce) {
    const Experiment e{.name = "n",
                       .finding = "found",
                       .points = {{1, {{"spectral", 0}, {"packed", 2}}, "the point"}},
                       .fails = {{"spectral", 1, "w"}, {"packed", 1, "w"}}};
    const Plot plot = experiment_pages({{e}}, 0, "").at(0).plots.at(0);
    EXPECT_EQ(plot.title, "found");
    EXPECT_THAT(plot.caption, HasSubstr("spectral, packed: w. "));
    EXPECT_EQ(find(plot, "packed")->points[0].label, "the point");
    EXPECT_EQ(find(plot, "spectral")->points[0].label, "") << "the worst method carries the name";
    EXPECT_GT(find(plot, "spectral")->points[0].y, 0) << "a logarithm has no 0";
}

TEST(ExperimentPages, TellVariantsOfAMethodApart) {
    const Experiment e{
        .name = "n",
        .points = {{1, {{"spectral", 1}, {"spectral in fp16", 1}, {"spectral, dim", 1}, {"rgb", 1}}}}};
    const Plot plot = experiment_pages({{e}}, 0, "").at(0).plots.at(0);
    std::set<int> colors;
    for (const Series& series : plot.series)
        colors.insert(series.color);
    EXPECT_EQ(colors.size(), 4u);
    EXPECT_EQ(find(plot, "spectral")->color, method_color("spectral"));
}

TEST(ExperimentsJson, FollowsTheContract) {
    const auto json = nlohmann::json::parse(experiments_json(sample_experiments()));
    ASSERT_EQ(json["experiments"].size(), 8u);
    const auto& first = json["experiments"][0];
    EXPECT_EQ(first["unit"], "nm");
    EXPECT_EQ(first["points"][0]["x"], 100);
    EXPECT_EQ(first["points"][0]["delta_e"]["folded"], 0.004);
    EXPECT_EQ(first["fails"][0]["method"], "spectral");
    EXPECT_EQ(first["fails"][0]["at"], 5);
    EXPECT_TRUE(json["experiments"][1]["points"][4]["delta_e"]["spectral"].is_null()) << "an infinity";
    EXPECT_FALSE(first["points"][0].contains("point"));
    Experiment named{.name = "n", .points = {{1, {}, "lamp", {{"outside", 3}}}}};
    const auto point = nlohmann::json::parse(experiments_json({named}))["experiments"][0]["points"][0];
    EXPECT_EQ(point["point"], "lamp");
    EXPECT_EQ(point["outside"], 3);
    EXPECT_EQ(error_of([] { experiments_json({{.name = "\xFF"}}); }),
              "2: cannot write stability: not UTF-8: ?");
}

} // namespace
} // namespace metamer
