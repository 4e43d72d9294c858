// How cost grows, as rows of a file.
#pragma once

#include <string>
#include <vector>

#include "report/chart_picture.h"
#include "report/rows.h"

namespace metamer {

/// A method at one value of one swept thing.
struct GrowthRow {
    std::string panel{}, swept{}; ///< what is swept, in a word; with its unit
    bool log_x = true;
    std::string method{};
    double x = 0;
    double ms = 0;                                               ///< median, per frame
    double cost_ratio = 0, cost_ratio_q1 = 0, cost_ratio_q3 = 0; ///< to rgb-pow at the sweep's start
    double cost_ratio_here = 0;                                  ///< to rgb-pow at the same x

    bool operator==(const GrowthRow&) const = default;
};

struct Growth {
    ChartContext context;
    std::vector<GrowthRow> rows{};

    bool operator==(const Growth&) const = default;
};

/// As chart_csv, chart_json and read_chart_csv, with the same errors.
std::string growth_csv(const Growth& growth);
std::string growth_json(const Growth& growth);
Growth read_growth_csv(const std::string& text, const std::string& place);

/// Panels and curves in their order of appearance.
std::vector<CostPanel> cost_panels(const Growth& growth);

/// For people: one line per row; then per panel how flat the planned frame is: its greatest ratio over its
/// least.
std::string growth_table(const Growth& growth);

} // namespace metamer
