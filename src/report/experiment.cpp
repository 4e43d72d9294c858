#include "report/experiment.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/utf8.h"
#include "report/geometry.h"
#include "report/number_text.h"

namespace metamer {

namespace {

using Json = nlohmann::ordered_json;

constexpr double kLeastDifference = 1e-3; // CIEDE2000; below it everything is the same

std::string text(const std::string& value) {
    if (!is_utf8(value))
        throw bad_input("write", "stability", "not UTF-8: " + quotable(value));
    return value;
}

Json json_of(const Experiment& experiment) {
    Json points = Json::array(), fails = Json::array();
    for (const ExperimentPoint& point : experiment.points) {
        Json delta_e = Json::object();
        for (const auto& [method, difference] : point.delta_e)
            delta_e[text(method)] = difference;
        points.push_back({{"x", point.x}, {"delta_e", delta_e}});
        if (!point.name.empty())
            points.back()["point"] = text(point.name);
        for (const auto& [figure, value] : point.also)
            points.back()[text(figure)] = value;
    }
    for (const Failure& fail : experiment.fails)
        fails.push_back({{"method", text(fail.method)}, {"at", fail.at}, {"why", text(fail.why)}});
    return {{"name", text(experiment.name)},
            {"group", text(experiment.group)},
            {"finding", text(experiment.finding)},
            {"swept", text(experiment.swept)},
            {"unit", text(experiment.unit)},
            {"points", points},
            {"fails", fails},
            {"guard", text(experiment.guard)}};
}

std::string place_of(const Experiment& experiment, const Failure& fail) {
    return short_number(fail.at, experiment.discrete ? 4 : 3) +
           (experiment.unit.empty() ? "" : " " + experiment.unit);
}

// Each cause once, after the methods that it has failed.
std::string caption_of(const Experiment& experiment) {
    std::vector<std::pair<std::string, std::string>> causes;
    for (const Failure& fail : experiment.fails) {
        const auto known = std::find_if(causes.begin(), causes.end(),
                                        [&](const auto& cause) { return cause.second == fail.why; });
        if (known == causes.end())
            causes.emplace_back(fail.method, fail.why);
        else
            known->first += ", " + fail.method;
    }
    std::string out;
    for (const auto& [methods, why] : causes)
        out += methods + ": " + why + ". ";
    return out + (experiment.guard.empty() ? "" : "Guard: " + experiment.guard + ".");
}

// A method has its own color in every picture; a variant of one takes the first that is left, so that lines
// in one plot can be told apart.
std::map<std::string, int> colors_of(const std::set<std::string>& methods) {
    std::map<std::string, int> colors;
    std::set<int> taken;
    for (const std::string& method : methods)
        if (const int color = method_color(method);
            color != kColors - 1 && method.find(' ') == std::string::npos) {
            colors[method] = color;
            taken.insert(color);
        }
    int next = 0;
    for (const std::string& method : methods)
        if (!colors.contains(method)) {
            while (next < kColors && taken.contains(next))
                ++next;
            colors[method] = next++;
        }
    return colors;
}

// Between its neighbors the difference of a method runs straight on the plot.
double between(const Experiment& experiment, Px below, Px above, double at) {
    const bool log_y = below.y > 0 && above.y > 0;
    const auto x = [&](double v) { return experiment.log_x ? std::log(v) : v; };
    const auto y = [&](double v) { return log_y ? std::log(v) : v; };
    const double value = std::lerp(y(below.y), y(above.y), (x(at) - x(below.x)) / (x(above.x) - x(below.x)));
    return log_y ? std::exp(value) : value;
}

// The difference of the method where it fails; NaN if it was not measured there.
double difference_at(const Experiment& experiment, const Failure& fail) {
    std::optional<Px> below, above;
    for (const ExperimentPoint& point : experiment.points) {
        const auto found = point.delta_e.find(fail.method);
        if (found == point.delta_e.end())
            continue;
        if (point.x == fail.at)
            return found->second;
        if (point.x < fail.at && (!below || point.x > below->x))
            below = Px{point.x, found->second};
        if (point.x > fail.at && (!above || point.x < above->x))
            above = Px{point.x, found->second};
    }
    if (below && above)
        return between(experiment, *below, *above, fail.at);
    return below ? below->y : above ? above->y : std::nan("");
}

// The method that errs most; points with names carry theirs beside it.
std::string worst_method(const ExperimentPoint& point) {
    const auto worst = std::max_element(point.delta_e.begin(), point.delta_e.end(),
                                        [](const auto& a, const auto& b) { return a.second < b.second; });
    return worst == point.delta_e.end() ? "" : worst->first;
}

Plot plot_of(const Experiment& experiment, double tolerance) {
    const std::string unit = experiment.unit.empty() ? "" : ", " + experiment.unit;
    Plot plot{
        .title = experiment.finding.empty() ? experiment.name : experiment.finding,
        .caption = caption_of(experiment),
        .x = {.title = experiment.swept + unit, .scale = experiment.log_x ? Scale::log10 : Scale::linear},
        .y = {.title = "CIEDE2000", .scale = Scale::log10, .floor = kLeastDifference}};
    if (tolerance > 0)
        plot.lines.push_back({ReferenceLine::At::y, tolerance, "tolerance " + short_number(tolerance)});
    std::set<std::string> methods;
    for (const ExperimentPoint& point : experiment.points)
        for (const auto& [method, difference] : point.delta_e)
            methods.insert(method);
    const std::map<std::string, int> colors = colors_of(methods);
    for (const std::string& method : methods) {
        Series series{.label = method, .color = colors.at(method), .marker = Marker::none};
        for (const ExperimentPoint& point : experiment.points)
            if (const auto found = point.delta_e.find(method); found != point.delta_e.end())
                series.points.push_back(
                    {.x = point.x,
                     .y = found->second < kLeastDifference ? kLeastDifference : found->second,
                     .label = method == worst_method(point) ? point.name : ""});
        plot.series.push_back(std::move(series));
    }
    for (const Failure& fail : experiment.fails)
        plot.marks.push_back({fail.at, difference_at(experiment, fail), place_of(experiment, fail),
                              colors.contains(fail.method) ? colors.at(fail.method) : kColors - 1});
    return plot;
}

} // namespace

std::string experiments_json(const std::vector<Experiment>& experiments) {
    Json out{{"experiments", Json::array()}};
    for (const Experiment& experiment : experiments)
        out["experiments"].push_back(json_of(experiment));
    return out.dump(2) + "\n";
}

std::vector<Picture> experiment_pages(const std::vector<Experiment>& experiments, double tolerance,
                                      const std::string& note, int columns, int rows, int width_px,
                                      int height_px) {
    if (columns < 1 || rows < 1)
        throw bad_input("draw", "stability", "pages have at least one column and one row");
    std::vector<Picture> pages;
    const std::size_t most = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
    const std::size_t count = (experiments.size() + most - 1) / most;
    for (std::size_t i = 0; i < experiments.size(); ++i) {
        if (i % most == 0)
            pages.push_back(
                {.title = "Where methods fail" + (count > 1 ? ", " + std::to_string(pages.size() + 1) +
                                                                  " of " + std::to_string(count)
                                                            : ""),
                 .subtitle = "Each line is a method's color difference against the reference while one "
                             "thing is swept; a ring is where it fails.",
                 .note = note,
                 .width_px = width_px,
                 .height_px = height_px,
                 .columns = columns});
        pages.back().plots.push_back(plot_of(experiments[i], tolerance));
    }
    return pages;
}

} // namespace metamer
