// The pictures of `metamer chart`.
#pragma once

#include <string>
#include <vector>

#include "report/plot.h"
#include "report/rows.h"

namespace metamer {

/// Speed against accuracy: cost against CIEDE2000, both logarithmic. A sign is a row's mean, its bar reaches
/// delta_e_max, the bar's tick is the 95th percentile. Methods by color, named once with their worst pair;
/// squares are unquantized, hollow signs fp16; the rows of one method over its taps are a path. The frontier
/// is drawn by context.frontier_by through the rows that are on_frontier; chosen rows are ringed.
Picture chart_picture(const Chart& chart, int width_px = 1600, int height_px = 1000);

/// How a method's cost grows with one thing.
struct CostPoint {
    double x = 0;
    double cost_ratio = 0, cost_ratio_q1 = 0, cost_ratio_q3 = 0; ///< to `rgb` at the sweep's start
};
struct CostCurve {
    std::string method{};
    std::vector<CostPoint> points{};
};
struct CostPanel {
    std::string title{}; ///< e.g. "wavelengths"
    std::string swept{}; ///< the x axis with its unit
    bool log_x = true;
    std::vector<CostCurve> curves{};
};

/// One panel per swept thing, one line per method, two panels a row, all with one cost axis.
Picture cost_picture(const std::vector<CostPanel>& panels, const ChartContext& context, int width_px = 1600,
                     int height_px = 1000);

/// A method on a GPU, on paper.
struct RateRow {
    std::string gpu{}, method{};
    double frames_per_s = 0;
};

/// Frames per second by GPU, logarithmic, beside the lines of 60 and 30; `assumption` is the caption.
Picture rate_picture(const std::vector<RateRow>& rows, const std::string& assumption, const std::string& note,
                     int width_px = 1200, int height_px = 800);

} // namespace metamer
