#include "report/growth_rows.h"

#include <gmock/gmock.h>

#include "image/error_of.h"

namespace metamer {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

GrowthRow row(const std::string& panel, const std::string& method, double x, double cost) {
    return {.panel = panel,
            .swept = panel + " n",
            .log_x = panel != "lamps",
            .method = method,
            .x = x,
            .ms = 10 * cost,
            .cost_ratio = cost,
            .cost_ratio_q1 = cost * 0.9,
            .cost_ratio_q3 = cost * 1.1,
            .cost_ratio_here = cost / 2};
}

Growth sample() {
    return {{.gl_renderer = "r", .timer = "glFinish", .rounds = 3},
            {row("lamps", "rgb", 1, 1), row("lamps", "planned", 1, 0.5), row("lamps", "rgb", 2, 2),
             row("lamps", "planned", 2, 0.6), row("pixels", "planned", 10, 0.5)}};
}

TEST(GrowthRows, ReadBackAsTheSame) {
    EXPECT_EQ(read_growth_csv(growth_csv(sample()), "g.csv"), sample());
}

TEST(GrowthRows, BecomePanelsAndCurves) {
    const auto panels = cost_panels(sample());
    ASSERT_THAT(panels, SizeIs(2));
    EXPECT_EQ(panels[0].title, "lamps");
    EXPECT_EQ(panels[0].swept, "lamps n");
    EXPECT_FALSE(panels[0].log_x);
    EXPECT_TRUE(panels[1].log_x);
    ASSERT_THAT(panels[0].curves, SizeIs(2));
    EXPECT_EQ(panels[0].curves[1].method, "planned");
    EXPECT_EQ(panels[0].curves[1].points[1].x, 2);
    EXPECT_EQ(panels[0].curves[1].points[1].cost_ratio, 0.6);
    EXPECT_EQ(panels[0].curves[1].points[1].cost_ratio_q3, 0.6 * 1.1);
}

TEST(GrowthRows, SayHowFlatThePlannedFrameIs) {
    EXPECT_THAT(growth_table(sample()), HasSubstr("lamps: planned costs 0.500 .. 0.600, 20.0 % apart\n"));
}

TEST(GrowthRows, AreNoChartRows) {
    EXPECT_EQ(error_of([] { read_chart_csv(growth_csv(sample()), "g.csv"); }),
              "2: cannot read g.csv:14: no column is named \"panel\"");
    EXPECT_EQ(error_of([] {
                  growth_csv({{}, {row("a\nb", "m", 1, 1)}});
              }),
              "2: cannot write growth rows: row 1: panel is not one line of UTF-8: a?b");
}

} // namespace
} // namespace metamer
