#include <algorithm>

#include "report/chart_picture.h"
#include "report/number_text.h"

namespace metamer {

namespace {

double index_of(std::vector<std::string>& names, const std::string& name) {
    auto at = std::find(names.begin(), names.end(), name);
    if (at == names.end())
        at = names.insert(at, name);
    return static_cast<double>(at - names.begin());
}

} // namespace

Picture rate_picture(const std::vector<RateRow>& rows, const std::string& assumption, const std::string& note,
                     int width_px, int height_px) {
    Plot plot{
        .caption = assumption,
        .x = {.title = "frames per second at 1280x720, on paper", .scale = Scale::log10},
        .lines = {{ReferenceLine::At::x, 60, "60 frames/s"}, {ReferenceLine::At::x, 30, "30 frames/s"}}};
    for (const RateRow& row : rows) {
        const double level = index_of(plot.y.categories, row.gpu);
        plot.series.push_back({.label = row.method,
                               .second_line = short_number(row.frames_per_s, 2) + " frames/s",
                               .points = {{.x = row.frames_per_s, .y = level}},
                               .color = method_color(row.method),
                               .stroke = Stroke::none});
    }
    return {.title = "What old GPUs could draw",
            .subtitle = "Right of the dashed lines a method is fluent on that GPU.",
            .note = note,
            .width_px = width_px,
            .height_px = height_px,
            .plots = {plot}};
}

} // namespace metamer
