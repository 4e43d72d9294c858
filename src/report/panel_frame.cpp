#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "report/panel.h"

namespace metamer {

namespace {

// Sizes in em.
constexpr double kTickText = 0.85, kTickGap = 0.45, kGutterMost = 0.28 /* of the panel's width */;

struct Values {
    std::vector<double> x, y;
};

void add(std::vector<double>& values, double value, const std::optional<Spread>& spread) {
    values.push_back(value);
    if (spread)
        values.insert(values.end(), {spread->low, spread->high});
}

Values values_of(const Plot& plot) {
    Values out;
    for (const Series& series : plot.series)
        for (const PlotPoint& point : series.points) {
            add(out.x, point.x, point.x_spread);
            add(out.y, point.y, point.y_spread);
        }
    for (const Mark& mark : plot.marks) {
        out.x.push_back(mark.x);
        out.y.push_back(mark.y);
    }
    for (const ReferenceLine& line : plot.lines)
        (line.at == ReferenceLine::At::x ? out.x : out.y).push_back(line.value);
    return out;
}

double widest_tick(Canvas& canvas, const Ticks& ticks, const Font& font, double most) {
    double widest = 0;
    for (const Tick& tick : ticks.major)
        widest = std::max(widest, canvas.width(canvas.fitted(tick.label, font, most), font));
    return widest;
}

// Lines that run to the right end have their names beside it.
double gutter(Canvas& canvas, const Plot& plot, double em, double most) {
    double widest = 0;
    for (const Series& series : plot.series)
        if (series.stroke != Stroke::none && !series.label_first && !series.faint)
            widest = std::max(widest, canvas.width(drawable(series.label), {em * 0.9, true}));
    return widest == 0 ? em * 0.8 : std::min(widest + em * 0.6, most);
}

} // namespace

PanelFrame panel_frame(Canvas& canvas, const Plot& plot, const Box& panel, double em) {
    const Font tick{em * kTickText}, caption{em * 0.9};
    const double line = canvas.line_height({em});
    const auto values = values_of(plot);
    const Range x = fitted_range(plot.x, values.x), y = fitted_range(plot.y, values.y);
    const auto caption_lines = canvas.wrapped(plot.caption, caption, panel.width(), 4);
    const double title = plot.title.empty() ? 0 : line * 1.15;
    const double heading = plot.y.title.empty() ? line * 0.4 : line * 1.1;

    Box area = panel;
    area.top += title + heading;
    area.bottom -= line * 1.15 + (plot.x.title.empty() ? 0 : line) +
                   canvas.line_height(caption) * static_cast<double>(caption_lines.size());
    const auto y_ticks = ticks(plot.y, y, std::clamp(static_cast<int>(area.height() / (em * 2.6)), 2, 12));
    area.left += widest_tick(canvas, y_ticks, tick, panel.width() * 0.3) + em * kTickGap;
    area.right -= gutter(canvas, plot, em, panel.width() * kGutterMost);
    if (area.width() < 4 * em || area.height() < 3 * em)
        throw bad_input("draw", "the plot " + plot.title, "there is no room for it; draw a larger picture");
    const auto x_ticks = ticks(plot.x, x, std::clamp(static_cast<int>(area.width() / (em * 4.5)), 2, 14));

    // On reversed y, categories read from the top.
    const bool down = !plot.y.categories.empty();
    return {.panel = panel,
            .area = area,
            .labels = {area.left, area.top, panel.right, area.bottom},
            .x = AxisMap(plot.x.scale, x, area.left, area.right),
            .y = AxisMap(plot.y.scale, y, down ? area.top : area.bottom, down ? area.bottom : area.top),
            .x_ticks = x_ticks,
            .y_ticks = y_ticks,
            .caption = caption_lines,
            .em = em};
}

namespace {

void draw_titles(Canvas& canvas, const Plot& plot, const PanelFrame& frame) {
    const double em = frame.em, line = canvas.line_height({em});
    const Font title{em, true}, axis{em * 0.9}, caption{em * 0.9};
    double y = frame.panel.top + canvas.ascent(title);
    if (!plot.title.empty()) {
        canvas.text({frame.panel.left, y}, canvas.fitted(plot.title, title, frame.panel.width()), title,
                    kInk);
        y += line * 1.15;
    }
    // Level and above its axis: read without turning the head.
    canvas.text({frame.panel.left, y}, canvas.fitted(plot.y.title, axis, frame.panel.width()), axis, kInk);
    y = frame.area.bottom + line * 1.15 + canvas.ascent(axis);
    if (!plot.x.title.empty()) {
        const std::string text = canvas.fitted(plot.x.title, axis, frame.panel.width());
        const double width = canvas.width(text, axis);
        const double centered = frame.area.center().x - width / 2;
        canvas.text({std::clamp(centered, frame.panel.left, frame.panel.right - width), y}, text, axis, kInk);
        y += line;
    }
    for (const std::string& text : frame.caption) {
        canvas.text({frame.panel.left, y}, text, caption, kFaded);
        y += canvas.line_height(caption);
    }
}

void draw_regions(Canvas& canvas, const Plot& plot, const PanelFrame& frame) {
    for (const Region& region : plot.regions) {
        const double x0 = region.x_low ? frame.x(*region.x_low).at : frame.area.left;
        const double x1 = region.x_high ? frame.x(*region.x_high).at : frame.area.right;
        const double y0 = region.y_low ? frame.y(*region.y_low).at : frame.area.bottom;
        const double y1 = region.y_high ? frame.y(*region.y_high).at : frame.area.top;
        canvas.fill({std::min(x0, x1), std::min(y0, y1), std::max(x0, x1), std::max(y0, y1)},
                    {0.84, 0.37, 0.0}, 0.10);
    }
}

void draw_grid(Canvas& canvas, const PanelFrame& frame) {
    const Box& area = frame.area;
    const auto vertical = [&](double value, double width) {
        const double x = frame.x(value).at;
        canvas.line({x, area.top}, {x, area.bottom}, {kHairline, width});
    };
    const auto level = [&](double value, double width) {
        const double y = frame.y(value).at;
        canvas.line({area.left, y}, {area.right, y}, {kHairline, width});
    };
    for (const double value : frame.x_ticks.minor)
        vertical(value, 0.5);
    for (const double value : frame.y_ticks.minor)
        level(value, 0.5);
    for (const Tick& tick : frame.x_ticks.major)
        vertical(tick.value, 1.1);
    for (const Tick& tick : frame.y_ticks.major)
        level(tick.value, 1.1);
}

void draw_ticks(Canvas& canvas, const PanelFrame& frame) {
    const Font font{frame.em * kTickText};
    const double below = frame.area.bottom + frame.em * 0.25 + canvas.ascent(font);
    double taken = frame.panel.left;
    for (const Tick& tick : frame.x_ticks.major) {
        const double width = canvas.width(tick.label, font);
        const double left = std::min(frame.x(tick.value).at - width / 2, frame.panel.right - width);
        if (left < taken)
            continue;
        canvas.text({left, below}, tick.label, font, kFaded);
        taken = left + width + frame.em * 0.4;
    }
    const double most = frame.panel.width() * 0.3;
    for (const Tick& tick : frame.y_ticks.major) {
        const std::string text = canvas.fitted(tick.label, font, most);
        const double right = frame.area.left - frame.em * kTickGap;
        canvas.text({right - canvas.width(text, font), frame.y(tick.value).at + canvas.ascent(font) * 0.36},
                    text, font, kFaded);
    }
}

} // namespace

void draw_panel_frame(Canvas& canvas, const Plot& plot, const PanelFrame& frame) {
    draw_regions(canvas, plot, frame);
    draw_grid(canvas, frame);
    const Box& area = frame.area;
    canvas.line({area.left, area.bottom}, {area.right, area.bottom}, {kFaded, 1});
    canvas.line({area.left, area.top}, {area.left, area.bottom}, {kFaded, 1});
    draw_ticks(canvas, frame);
    draw_titles(canvas, plot, frame);
}

} // namespace metamer
