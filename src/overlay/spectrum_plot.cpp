#include "overlay/spectrum_plot.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "color/grid.h"

namespace metamer {

namespace {

struct FreePattern {
    void operator()(cairo_pattern_t* pattern) const { cairo_pattern_destroy(pattern); }
};
using Pattern = std::unique_ptr<cairo_pattern_t, FreePattern>;

/// Where a wavelength stands: each interval has its 5 nm, so that half of one lies outside both ends.
double x_of(double wavelength_nm, const Rect& rect) {
    const double from = kThesisGrid.first_nm - kThesisGrid.step_nm / 2;
    return rect.x + (wavelength_nm - from) / (kThesisGrid.step_nm * kIntervals) * rect.w;
}

Pattern colors_over(const Rect& rect, double alpha) {
    Pattern pattern(cairo_pattern_create_linear(rect.x, 0, rect.right(), 0));
    const std::vector<Srgb>& colors = wavelength_colors();
    for (std::size_t i = 0; i < colors.size(); ++i) {
        const double at = (static_cast<double>(i) + 0.5) / static_cast<double>(colors.size());
        cairo_pattern_add_color_stop_rgba(pattern.get(), at, colors[i][0] / 255.0, colors[i][1] / 255.0,
                                          colors[i][2] / 255.0, alpha);
    }
    return pattern;
}

double height_of(float value) {
    return std::isfinite(value) ? std::clamp(static_cast<double>(value), 0.0, 1.0) : 0.0;
}

/// The line over the bars, held to both sides of the rectangle.
void trace(cairo_t* cairo, const Rect& rect, const Bars& bars) {
    const auto y = [&](std::size_t i) { return rect.bottom() - height_of(bars[i]) * rect.h; };
    const std::size_t count = std::min(bars.size(), kIntervals);
    cairo_line_to(cairo, rect.x, y(0));
    for (std::size_t i = 0; i < count; ++i)
        cairo_line_to(cairo, x_of(kThesisGrid.wavelength_nm(i), rect), y(i));
    cairo_line_to(cairo, rect.right(), y(count - 1));
}

void paint_axis(Brush& brush, const Rect& plot, const Rect& labels) {
    cairo_t* cairo = brush.cairo();
    const double width = 0.16 * plot.w;
    const bool crowded = plot.w < 30 * brush.unit();
    for (const int nm : {400, 500, 600, 700}) {
        const double x = x_of(nm, plot);
        brush.color(kPlotTone.faded);
        cairo_rectangle(cairo, std::floor(x), plot.bottom(), 1, std::max(0.2 * labels.h, 2.0));
        cairo_fill(cairo);
        const bool last = nm == 700;
        if (crowded && nm == 600) // leaves its place to `700 nm`
            continue;
        const double left = last ? plot.right() - 2 * width : std::max(x - width / 2, plot.x);
        const Rect at{left, labels.y + 0.2 * labels.h, last ? 2 * width : width, 0.8 * labels.h};
        brush.write(std::to_string(nm) + (last ? "\u00a0nm" : ""), at,
                    {1.9, kPlotTone.faded, last ? Align::right : Align::center, Stand::top, false, 1, true});
    }
}

} // namespace

void paint_spectrum(const Brush& brush, const Rect& rect, const Bars& bars) {
    if (bars.empty())
        return;
    cairo_t* cairo = brush.cairo();
    cairo_save(cairo);
    cairo_rectangle(cairo, rect.x, rect.y, rect.w, rect.h);
    cairo_clip(cairo);
    cairo_move_to(cairo, rect.x, rect.bottom());
    trace(cairo, rect, bars);
    cairo_line_to(cairo, rect.right(), rect.bottom());
    cairo_close_path(cairo);
    cairo_set_source(cairo, colors_over(rect, 1).get());
    cairo_fill(cairo);
    cairo_restore(cairo);
}

void paint_plot(Brush& brush, Rect rect, const Bars& bars) {
    const Rect labels = rect.cut_bottom(kAxisHeight * brush.unit());
    cairo_t* cairo = brush.cairo();
    brush.fill(rect, 0, kPlotTone);
    const Rect plot = rect;
    cairo_rectangle(cairo, plot.x, plot.y, plot.w, plot.h);
    cairo_set_source(cairo, colors_over(plot, 0.12).get());
    cairo_fill(cairo);
    paint_spectrum(brush, plot, bars);
    brush.color(kPlotTone.faded);
    cairo_rectangle(cairo, plot.x, plot.bottom() - 1, plot.w, 1);
    cairo_fill(cairo);
    paint_axis(brush, plot, labels);
}

} // namespace metamer
