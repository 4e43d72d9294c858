#include "report/chart_measure.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <map>
#include <set>

#include "exhibit/load.h"
#include "gles/surfaceless.h"
#include "methods/taps.h"
#include "report/chart_exhibits.h"
#include "report/chart_table.h"

namespace metamer {
namespace {

using testing::Each;
using testing::HasSubstr;
using testing::SizeIs;

class MeasureChart : public testing::Test {
protected:
    static Chart measured(const std::string& scene) {
        return measure_chart(parse_exhibit("[display]\nwidth = 16\nheight = 16\n" + scene, "the test", "."),
                             {}, 2);
    }

    Surfaceless context_;
};

constexpr const char* kLoaf = "[scene]\nkind = loaf\nmaterials = crayon-red, crayon-blue\n"
                              "[lamp.1]\nspectrum = F11\n[lamp.2]\nspectrum = D65\n";

std::vector<ChartRow> rows_of(const Chart& chart, std::string_view method) {
    std::vector<ChartRow> out;
    std::copy_if(chart.rows.begin(), chart.rows.end(), std::back_inserter(out),
                 [&](const ChartRow& row) { return row.method == method; });
    return out;
}

void expect_every_method_in_every_way(const Chart& chart) {
    EXPECT_EQ(chart.context.left_out, "");
    EXPECT_THAT(chart.rows, SizeIs(4 * (6 + kTapCounts.size() + 2)));
    std::set<std::tuple<std::string, int, Precision, Levels>> ways;
    for (const ChartRow& row : chart.rows)
        ways.insert({row.method, row.taps, row.precision, row.atlas});
    EXPECT_THAT(ways, SizeIs(chart.rows.size()));
    EXPECT_EQ(chart.context.lamps, 2);
    EXPECT_EQ(chart.context.materials, 2);
    EXPECT_EQ(chart.context.rounds, 2);
    EXPECT_EQ(chart.context.width_px, 16);
    EXPECT_EQ(chart.context.tolerance, 0.5);
}

void expect_ratios_to_rgb_with_pow(const Chart& chart) {
    const auto base = rows_of(chart, kBaseName), rgb = rows_of(chart, "rgb");
    ASSERT_THAT(base, SizeIs(4));
    for (const ChartRow& row : base) {
        EXPECT_EQ(row.cost_ratio, 1);
        EXPECT_EQ(row.cost_ratio_q1, 1);
        EXPECT_EQ(row.cost_ratio_q3, 1);
    }
    for (std::size_t i = 0; i < rgb.size(); ++i)
        EXPECT_EQ(rgb[i].delta_e_max, base[i].delta_e_max) << "the same colors, another curve";
    for (const ChartRow& row : chart.rows) {
        EXPECT_GT(row.ms, 0);
        EXPECT_LE(row.cost_ratio_q1, row.cost_ratio);
        EXPECT_LE(row.cost_ratio, row.cost_ratio_q3);
        EXPECT_LE(row.delta_e_mean, row.delta_e_max);
        EXPECT_LE(row.delta_e_p95, row.delta_e_max);
    }
}

void expect_the_worst_pair(const Chart& chart) {
    const auto row = rows_of(chart, "tristimulus").front();
    const AccuracyProbe probe(parse_exhibit(kLoaf, "the test", "."));
    double worst = 0;
    for (const PairDifference& pair : probe.differences({Method::tristimulus, 0, row.precision, row.atlas})) {
        worst = std::max(worst, pair.delta_e);
        if (pair.lamp == row.worst_lamp && pair.material == row.worst_material) {
            EXPECT_EQ(pair.delta_e, row.delta_e_max);
        }
    }
    EXPECT_EQ(row.delta_e_max, worst);
    EXPECT_EQ(row.worst_lamp, "F11");
}

void expect_what_the_planner_took(const Chart& chart) {
    for (const ChartRow& row : chart.rows)
        EXPECT_EQ(row.chosen, row.method == "folded" && row.precision == Precision::fp32 &&
                                  row.atlas == Levels::unquantized)
            << row.method;
    const auto planned = rows_of(chart, kPlannedName), folded = rows_of(chart, "folded");
    for (std::size_t i = 0; i < planned.size(); ++i)
        EXPECT_EQ(planned[i].delta_e_max, folded[i].delta_e_max);
}

void expect_the_frontier(const Chart& chart) {
    std::vector<ChartRow> again = chart.rows;
    mark_frontier(again, FrontierBy::max);
    EXPECT_EQ(again, chart.rows);
    EXPECT_TRUE(std::any_of(again.begin(), again.end(), [](const ChartRow& row) { return row.on_frontier; }));
}

// One chart for all: measuring compiles every method's shaders.
TEST_F(MeasureChart, IsCompleteAndConsistent) {
    const Chart chart = measured(kLoaf);
    expect_every_method_in_every_way(chart);
    expect_ratios_to_rgb_with_pow(chart);
    expect_the_worst_pair(chart);
    expect_what_the_planner_took(chart);
    expect_the_frontier(chart);
}

TEST_F(MeasureChart, LeavesOutWhatCannotDrawAMedium) {
    const Chart chart = measured("[scene]\nkind = media\n[lamp.1]\nspectrum = D65\n");
    EXPECT_THAT(chart.context.left_out, HasSubstr("folded: method folded is a constant"));
    EXPECT_THAT(rows_of(chart, "folded"), SizeIs(0));
    EXPECT_THAT(rows_of(chart, "reduced"), SizeIs(4 * kTapCounts.size()));
    EXPECT_THAT(chart_table(chart), HasSubstr("left out: folded"));
    EXPECT_THAT(rows_of(chart, "spectral").front().worst_material, HasSubstr(" through "));
}

TEST_F(MeasureChart, TakesOtherPairs) {
    const Exhibit exhibit =
        parse_exhibit(std::string("[display]\nwidth = 16\nheight = 16\n") + kLoaf, "the test", ".");
    const auto pairs =
        pair_exhibits(library_lamps().subspan(0, 3), library_materials().subspan(0, 2), exhibit.display);
    const Chart chart = measure_chart(exhibit, pairs, 1);
    EXPECT_EQ(chart.context.lamps, 3);
    EXPECT_EQ(chart.context.materials, 2);
    EXPECT_THAT(chart_table(chart), HasSubstr("3 lamps × 2 materials"));
}

TEST(LevelsKnown, IsTheAtlasWhereASpectrumIsNotAtHand) {
    const Exhibit exhibit = parse_exhibit(kLoaf, "the test", ".");
    EXPECT_EQ(levels_known(exhibit), Levels::unquantized);
    EXPECT_EQ(levels_known(from_atlas_alone(exhibit)), Levels::eight_bit);
    Exhibit one_row = exhibit;
    one_row.materials.erase(one_row.materials.begin());
    EXPECT_EQ(levels_known(one_row), Levels::eight_bit);
}

} // namespace
} // namespace metamer
