#include "report/growth_rows.h"

#include <algorithm>

#include "base/printed.h"
#include "report/context_note.h"
#include "report/field_csv.h"

namespace metamer {

namespace {

template <class Of>
Of& named(std::vector<Of>& list, std::string Of::*name, const std::string& value) {
    const auto at =
        std::find_if(list.begin(), list.end(), [&](const Of& each) { return each.*name == value; });
    if (at != list.end())
        return *at;
    list.emplace_back().*name = value;
    return list.back();
}

std::string flatness(const CostPanel& panel) {
    for (const CostCurve& curve : panel.curves)
        if (curve.method == "planned") {
            const auto [least, most] = std::minmax_element(
                curve.points.begin(), curve.points.end(),
                [](const CostPoint& a, const CostPoint& b) { return a.cost_ratio < b.cost_ratio; });
            return printed("%s: planned costs %.3f .. %.3f, %.1f %% apart\n", panel.title.c_str(),
                           least->cost_ratio, most->cost_ratio,
                           100 * (most->cost_ratio / least->cost_ratio - 1));
        }
    return "";
}

} // namespace

std::string growth_csv(const Growth& growth) {
    return fields_csv(growth.context, growth.rows, "growth rows");
}

std::string growth_json(const Growth& growth) {
    return fields_json(growth.context, growth.rows, "growth rows");
}

Growth read_growth_csv(const std::string& text, const std::string& place) {
    Growth growth;
    read_fields_csv(text, place, growth.context, growth.rows, [](const GrowthRow&, int) {});
    return growth;
}

std::vector<CostPanel> cost_panels(const Growth& growth) {
    std::vector<CostPanel> panels;
    for (const GrowthRow& row : growth.rows) {
        CostPanel& panel = named(panels, &CostPanel::title, row.panel);
        panel.swept = row.swept;
        panel.log_x = row.log_x;
        named(panel.curves, &CostCurve::method, row.method)
            .points.push_back({row.x, row.cost_ratio, row.cost_ratio_q1, row.cost_ratio_q3});
    }
    return panels;
}

std::string growth_table(const Growth& growth) {
    std::string out =
        context_note(growth.context) + "\n" +
        printed(
            "timed by %s, %d rounds; cost: to rgb-pow at the sweep's start; here: to rgb-pow at the same x\n",
            growth.context.timer.c_str(), growth.context.rounds);
    std::string panel;
    for (const GrowthRow& row : growth.rows) {
        if (row.panel != panel)
            out += "\n" + (panel = row.panel) + "\n" +
                   printed("%-12s %8s %8s %7s  %14s %7s\n", "method", "x", "ms", "cost", "quartiles", "here");
        out += printed("%-12s %8g %8.2f %7.3f  %6.3f..%6.3f %7.3f\n", row.method.c_str(), row.x, row.ms,
                       row.cost_ratio, row.cost_ratio_q1, row.cost_ratio_q3, row.cost_ratio_here);
    }
    out += "\n";
    for (const CostPanel& each : cost_panels(growth))
        out += flatness(each);
    return out;
}

} // namespace metamer
