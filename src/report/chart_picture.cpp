#include "report/chart_picture.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "report/context_note.h"
#include "report/number_text.h"

namespace metamer {

namespace {

constexpr double kLeastDifference = 1e-3; // CIEDE2000; a tenth of what a screen of 8 bits can show
constexpr double kMatters = 1.25;         // a variant that differs by this factor gets its own words

using Group = std::vector<const ChartRow*>; // rows of one method, precision and atlas, by taps

std::vector<Group> groups_of(const std::vector<ChartRow>& rows) {
    std::vector<std::string> methods; // in order of appearance
    std::map<std::tuple<std::size_t, Levels, int>, Group> groups;
    for (const ChartRow& row : rows) {
        auto at = std::find(methods.begin(), methods.end(), row.method);
        if (at == methods.end())
            at = methods.insert(at, row.method);
        const int fp32_first = row.precision == Precision::fp32 ? 0 : 1;
        groups[{static_cast<std::size_t>(at - methods.begin()), row.atlas, fp32_first}].push_back(&row);
    }
    std::vector<Group> out;
    for (auto& [key, group] : groups) {
        std::stable_sort(group.begin(), group.end(),
                         [](const ChartRow* a, const ChartRow* b) { return a->taps < b->taps; });
        out.push_back(std::move(group));
    }
    return out;
}

std::string variant_words(const ChartRow& row, const ChartRow& than) {
    std::string out = row.precision == than.precision    ? ""
                      : row.precision == Precision::fp16 ? "fp16"
                                                         : "fp32";
    if (row.atlas != than.atlas)
        out += (out.empty() ? "" : ", ") +
               std::string(row.atlas == Levels::unquantized ? "unquantized" : "8-bit");
    return out;
}

bool apart(double a, double b) {
    const double high = std::max({a, b, kLeastDifference}), low = std::max(std::min(a, b), kLeastDifference);
    return high > low * kMatters;
}

bool differs(const ChartRow& a, const ChartRow& b) {
    return apart(a.cost_ratio, b.cost_ratio) || apart(a.delta_e_mean, b.delta_e_mean) ||
           apart(a.delta_e_max, b.delta_e_max);
}

PlotPoint point_of(const ChartRow& row) {
    return {.x = row.cost_ratio,
            .y = row.delta_e_mean,
            .x_spread = Spread{row.cost_ratio_q1, row.cost_ratio_q3},
            .y_spread = Spread{row.delta_e_mean, row.delta_e_max, row.delta_e_p95}};
}

std::string worst_of(const Group& group) {
    const ChartRow& worst =
        **std::max_element(group.begin(), group.end(), [](const ChartRow* a, const ChartRow* b) {
            return a->delta_e_max < b->delta_e_max;
        });
    if (worst.worst_material.empty() && worst.worst_lamp.empty())
        return {};
    const std::string at = group.size() > 1 ? " (N = " + std::to_string(worst.taps) + ")" : "";
    return "worst " + short_number(worst.delta_e_max) + at + ": " + worst.worst_material + " under " +
           worst.worst_lamp;
}

// `first` is the method's first group, which carries its name; a variant is named where it differs.
Series series_of(const Group& group, const Group& first) {
    const ChartRow& row = *group.front();
    Series out{.color = method_color(row.method),
               .stroke = group.size() > 1 ? Stroke::solid : Stroke::none,
               .marker = row.atlas == Levels::unquantized ? Marker::square : Marker::disc,
               .hollow = row.precision == Precision::fp16,
               .label_first = true,
               .faint = &group != &first};
    const bool named = &group == &first;
    if (named) {
        out.label = row.method + (group.size() > 1 ? ", N ="
                                  : row.taps > 0   ? " " + std::to_string(row.taps)
                                                   : "");
        out.second_line = worst_of(group);
    }
    for (const ChartRow* each : group) {
        out.points.push_back(point_of(*each));
        const auto same = std::find_if(first.begin(), first.end(),
                                       [&](const ChartRow* other) { return other->taps == each->taps; });
        if (named)
            out.points.back().label = group.size() > 1 ? std::to_string(each->taps) : "";
        else if (each == group.back() && (same == first.end() || differs(*each, **same)))
            out.points.back().label = variant_words(*each, *first.front());
    }
    return out;
}

Series frontier_of(const Chart& chart) {
    Series out{.color = kColors - 1, .stroke = Stroke::steps, .marker = Marker::none, .label_first = true};
    for (const ChartRow& row : chart.rows)
        if (row.on_frontier)
            out.points.push_back({.x = row.cost_ratio, .y = accuracy(row, chart.context.frontier_by)});
    std::sort(out.points.begin(), out.points.end(),
              [](const PlotPoint& a, const PlotPoint& b) { return std::tie(a.x, b.y) < std::tie(b.x, a.y); });
    return out;
}

std::vector<ReferenceLine> references(const ChartContext& context) {
    std::vector<ReferenceLine> out{{ReferenceLine::At::x, 1, "rgb = 1"}};
    if (context.tolerance > 0)
        out.push_back(
            {ReferenceLine::At::y, context.tolerance, "tolerance " + short_number(context.tolerance)});
    if (context.tolerance != 1)
        out.push_back({ReferenceLine::At::y, 1, "just visible: 1"});
    return out;
}

std::vector<KeyItem> key_of(const Chart& chart) {
    using Sign = KeyItem::Sign;
    const auto any = [&](auto&& is) { return std::any_of(chart.rows.begin(), chart.rows.end(), is); };
    std::vector<KeyItem> out{{.sign = Sign::bar, .text = "mean, 95th percentile, worst pair"}};
    if (any([](const ChartRow& row) { return row.atlas == Levels::unquantized; }))
        out.insert(out.end(), {{.text = "8-bit atlas"}, {.marker = Marker::square, .text = "unquantized"}});
    if (any([](const ChartRow& row) { return row.precision == Precision::fp16; }))
        out.push_back({.hollow = true, .text = "hollow: fp16"});
    if (any([](const ChartRow& row) { return row.on_frontier; }))
        out.push_back({.sign = Sign::line,
                       .text = std::string("frontier: nothing is both cheaper and closer (by the ") +
                               (chart.context.frontier_by == FrontierBy::max ? "worst pair)" : "mean)")});
    return out;
}

} // namespace

Picture chart_picture(const Chart& chart, int width_px, int height_px) {
    Plot plot{
        .x = {.title = "time per frame, relative to rgb with pow()", .scale = Scale::log10},
        .y = {.title = "CIEDE2000 against the reference", .scale = Scale::log10, .floor = kLeastDifference},
        .lines = references(chart.context)};
    plot.series.push_back(frontier_of(chart));
    const auto groups = groups_of(chart.rows);
    const Group* first = nullptr;
    for (const Group& group : groups) {
        if (!first || first->front()->method != group.front()->method)
            first = &group;
        plot.series.push_back(series_of(group, *first));
    }
    for (const ChartRow& row : chart.rows)
        if (row.chosen)
            plot.marks.push_back(
                {row.cost_ratio, row.delta_e_mean, "planner's choice", method_color(row.method)});
    return {
        .title =
            "Speed against accuracy" + (chart.context.exhibit.empty() ? "" : ": " + chart.context.exhibit),
        .subtitle =
            "The lower, the closer to the reference; the further left, the faster. Color differences over " +
            pairs_text(chart.context) + ".",
        .note = context_note(chart.context),
        .width_px = width_px,
        .height_px = height_px,
        .plots = {plot},
        .key = key_of(chart)};
}

} // namespace metamer
