#include "report/rows.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "image/error_of.h"
#include "report/samples.h"

namespace metamer {
namespace {

using namespace std::string_literals;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

ChartRow at(double cost, double mean, double max) {
    return {.method = "m", .cost_ratio = cost, .delta_e_mean = mean, .delta_e_max = max};
}

std::vector<bool> frontier(std::vector<ChartRow> rows, FrontierBy by) {
    mark_frontier(rows, by);
    std::vector<bool> out;
    for (const ChartRow& row : rows)
        out.push_back(row.on_frontier);
    return out;
}

TEST(Frontier, KeepsWhatNothingBeats) {
    const std::vector<ChartRow> rows{at(1, 5, 60), at(2, 1, 10), at(3, 1, 5), at(4, 2, 20), at(1, 6, 50)};
    EXPECT_THAT(frontier(rows, FrontierBy::mean), ElementsAre(true, true, false, false, false));
    EXPECT_THAT(frontier(rows, FrontierBy::max), ElementsAre(false, true, true, false, true));
}

TEST(Frontier, EqualRowsStandTogether) {
    EXPECT_THAT(frontier({at(1, 1, 1), at(1, 1, 1), at(1, 2, 2)}, FrontierBy::max),
                ElementsAre(true, true, false));
}

TEST(Frontier, ForgetsWhatRowsSaidBefore) {
    std::vector<ChartRow> rows{at(1, 1, 1), at(2, 2, 2)};
    rows[1].on_frontier = true;
    EXPECT_THAT(frontier(rows, FrontierBy::max), ElementsAre(true, false));
    EXPECT_TRUE(frontier({}, FrontierBy::max).empty());
}

TEST(ChartCsv, ReadsBackAsTheSame) {
    const Chart chart = sample_chart();
    EXPECT_EQ(read_chart_csv(chart_csv(chart), "a.csv"), chart);
}

TEST(ChartCsv, HasTheNamesOfTheContract) {
    EXPECT_THAT(chart_csv({}),
                HasSubstr("\nmethod,taps,precision,atlas,ms,ms_q1,ms_q3,cost_ratio,cost_ratio_q1,"
                          "cost_ratio_q3,delta_e_mean,delta_e_p95,delta_e_max,worst_lamp,"
                          "worst_material,on_frontier,chosen\n"));
}

TEST(ChartCsv, KeepsEveryBitOfANumber) {
    Chart chart;
    ChartRow row = at(1.0 / 3, 5e-324, std::numeric_limits<double>::max());
    row.ms = 0.1 + 0.2;
    chart.rows = {row};
    const Chart back = read_chart_csv(chart_csv(chart), "a.csv");
    EXPECT_EQ(back, chart);
    const auto json = nlohmann::json::parse(chart_json(chart))["rows"][0];
    EXPECT_EQ(json["ms"], row.ms);
    EXPECT_EQ(json["delta_e_mean"], 5e-324);
    EXPECT_EQ(json["delta_e_max"], row.delta_e_max);
}

TEST(ChartCsv, KeepsHostileNames) {
    for (const std::string& name : {"a,b"s, "say \"F11\""s, "# no comment"s, " blanks "s, "a;b"s, "<&>'"s,
                                    "ナトリウム"s, ""s, "=1+1"s, "\""s, "a,"s, std::string(5000, 'x')}) {
        Chart chart;
        chart.rows = {at(1, 1, 1), at(1, 1, 1)};
        chart.rows[0].method = chart.rows[0].worst_material = chart.rows[1].worst_lamp = name;
        EXPECT_EQ(read_chart_csv(chart_csv(chart), "a.csv"), chart) << name;
        EXPECT_EQ(nlohmann::json::parse(chart_json(chart))["rows"][0]["method"], name);
    }
}

TEST(ChartCsv, RefusesToWriteWhatCannotBeRead) {
    const auto refused = [](auto&& spoil) {
        Chart chart;
        chart.rows = {at(1, 1, 1), at(1, 1, 1)};
        spoil(chart);
        const std::string csv = error_of([&] { chart_csv(chart); });
        EXPECT_EQ(error_of([&] { chart_json(chart); }), csv);
        return csv;
    };
    EXPECT_EQ(refused([](Chart& c) { c.rows[1].ms = std::nan(""); }),
              "2: cannot write chart rows: row 2: ms is no number of at least 0");
    EXPECT_EQ(refused([](Chart& c) { c.rows[0].delta_e_max = HUGE_VAL; }),
              "2: cannot write chart rows: row 1: delta_e_max is no number of at least 0");
    EXPECT_EQ(refused([](Chart& c) { c.rows[0].taps = -1; }),
              "2: cannot write chart rows: row 1: taps is no number of at least 0");
    EXPECT_EQ(refused([](Chart& c) { c.rows[0].worst_lamp = "a\nb"; }),
              "2: cannot write chart rows: row 1: worst_lamp is not one line of UTF-8: a?b");
    EXPECT_EQ(refused([](Chart& c) { c.context.exhibit = "\xFF"; }),
              "2: cannot write chart rows: exhibit is not one line of UTF-8: ?");
}

std::string with(const std::string& from, const std::string& to) {
    Chart chart;
    chart.rows = {at(2, 1, 1)};
    std::string csv = chart_csv(chart);
    const std::size_t place = csv.find(from);
    EXPECT_NE(place, std::string::npos) << from;
    csv.replace(place, from.size(), to);
    return error_of([&] { read_chart_csv(csv, "a.csv"); });
}

TEST(ReadChartCsv, SaysWhatIsWrongAndWhere) {
    EXPECT_EQ(with("m,0,fp32", "m,0.5,fp32"),
              "2: cannot read a.csv:15: taps = 0.5 is no whole number of at least 0");
    EXPECT_EQ(with("m,0,fp32", "m,0,fp64"),
              "2: cannot read a.csv:15: precision = fp64 is neither fp16 nor fp32");
    EXPECT_EQ(with(",2,", ",-2,"), "2: cannot read a.csv:15: cost_ratio = -2 is no number of at least 0");
    EXPECT_EQ(with("false", "no"), "2: cannot read a.csv:15: on_frontier = no is neither true nor false");
    EXPECT_EQ(with(",2,", ",2,2,"), "2: cannot read a.csv:15: 18 cells under 17 columns");
    EXPECT_EQ(with(",taps", ",tap"),
              "2: cannot read a.csv:14: no column is named \"tap\"; did you mean \"taps\"?");
    EXPECT_EQ(with(",taps", ""), "2: cannot read a.csv:14: the column taps is missing");
    EXPECT_EQ(with(",taps", ",ms"), "2: cannot read a.csv:14: the column ms is there twice");
    EXPECT_EQ(with("tolerance: 0", "tolerance: x"),
              "2: cannot read a.csv: tolerance: x is no number of at least 0");
    EXPECT_EQ(error_of([] { read_chart_csv("", "a.csv"); }), "2: cannot read a.csv: it has no header line");
    EXPECT_EQ(error_of([] { read_chart_csv("\xFF\n", "a.csv"); }), "2: cannot read a.csv: it is not UTF-8");
}

TEST(ReadChartCsv, TakesColumnsInAnyOrder) {
    Chart chart;
    chart.rows = {at(2, 1, 1)};
    chart.rows[0].taps = 64;
    std::string csv = chart_csv(chart);
    csv.replace(csv.find("method,taps"), 11, "taps,method");
    csv.replace(csv.find("m,64"), 4, "64,m");
    EXPECT_EQ(read_chart_csv(csv, "a.csv"), chart);
}

TEST(ChartJson, HasTheSameRows) {
    const Chart chart = sample_chart();
    const auto json = nlohmann::ordered_json::parse(chart_json(chart));
    EXPECT_EQ(json["context"]["frontier_by"], "delta_e_max");
    EXPECT_EQ(json["context"]["lamps"], 45);
    ASSERT_EQ(json["rows"].size(), chart.rows.size());
    std::string names;
    for (const auto& [name, value] : json["rows"][0].items())
        names += (names.empty() ? "\n" : ",") + name;
    EXPECT_THAT(chart_csv(chart), HasSubstr(names + "\n"));
    EXPECT_EQ(json["rows"][0]["precision"], "fp32");
    EXPECT_EQ(json["rows"][0]["atlas"], "8-bit");
    EXPECT_EQ(json["rows"][0]["on_frontier"], chart.rows[0].on_frontier);
}

} // namespace
} // namespace metamer
