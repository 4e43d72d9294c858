#include <algorithm>

#include "report/chart_picture.h"
#include "report/context_note.h"

namespace metamer {

namespace {

Axis shared_cost_axis(const std::vector<CostPanel>& panels) {
    Axis axis{.title = "cost, relative to rgb", .scale = Scale::log10};
    std::vector<double> values;
    for (const CostPanel& panel : panels)
        for (const CostCurve& curve : panel.curves)
            for (const CostPoint& point : curve.points)
                values.insert(values.end(), {point.cost_ratio, point.cost_ratio_q1, point.cost_ratio_q3});
    const Range range = fitted_range(axis, values);
    axis.low = range.low;
    axis.high = range.high;
    return axis;
}

Plot plot_of(const CostPanel& panel, const Axis& cost) {
    Plot plot{.title = panel.title,
              .x = {.title = panel.swept, .scale = panel.log_x ? Scale::log10 : Scale::linear},
              .y = cost};
    for (const CostCurve& curve : panel.curves) {
        Series series{.label = curve.method, .color = method_color(curve.method)};
        for (const CostPoint& point : curve.points)
            series.points.push_back({.x = point.x,
                                     .y = point.cost_ratio,
                                     .y_spread = Spread{point.cost_ratio_q1, point.cost_ratio_q3}});
        plot.series.push_back(std::move(series));
    }
    return plot;
}

} // namespace

Picture cost_picture(const std::vector<CostPanel>& panels, const ChartContext& context, int width_px,
                     int height_px) {
    Picture out{.title = "What makes a frame cost more",
                .subtitle = "A level line costs nothing extra. Median and quartiles over interleaved rounds; "
                            "all panels share the cost axis.",
                .note = context_note(context),
                .width_px = width_px,
                .height_px = height_px,
                .columns = 2};
    const Axis cost = shared_cost_axis(panels);
    for (const CostPanel& panel : panels)
        out.plots.push_back(plot_of(panel, cost));
    return out;
}

} // namespace metamer
