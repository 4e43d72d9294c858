#include <algorithm>
#include <cmath>
#include <numbers>

#include "overlay/layout.h"
#include "overlay/spectrum_plot.h"
#include "overlay/widget_paint.h"

namespace metamer {

namespace {

constexpr double kMarkRadius = 1.5; ///< units

/// The ground of everything that can be pressed; chosen: lighter, framed.
void paint_ground(const Brush& brush, const Rect& whole, bool on) {
    const double radius = kCorner * brush.unit();
    brush.fill(whole, radius, on ? kChosenTone : kTileTone);
    if (on)
        brush.frame(whole, radius, kAmber, std::max(0.5 * brush.unit(), 2.0));
}

void disc(const Brush& brush, double x, double y, double radius, const Srgb& ink) {
    cairo_new_path(brush.cairo());
    cairo_arc(brush.cairo(), x, y, radius, 0, 2 * std::numbers::pi);
    brush.color(ink);
    cairo_fill(brush.cairo());
}

void bar(const Brush& brush, double from_x, double to_x, double middle_y, double thick, const Srgb& ink) {
    brush.round({std::min(from_x, to_x), middle_y - thick / 2, std::abs(to_x - from_x), thick}, thick / 2);
    brush.color(ink);
    cairo_fill(brush.cairo());
}

} // namespace

void paint_lamp(Brush& brush, const Widget& widget, const Rect& whole) {
    const double u = brush.unit();
    paint_ground(brush, whole, widget.on);
    Rect rest = whole.inset(0.8 * u, 0.8 * u);
    const Rect name = rest.cut_top(0.46 * whole.h);
    rest.cut_top(0.4 * u);
    TextStyle style{2.7, kTileTone.ink, Align::center, Stand::middle, widget.on, 2};
    style.one_line = 0.88;
    if (!widget.text.empty() && name.w >= 1 && name.h >= 1)
        brush.write(brush.fitted_as_bold(widget.text, name, style).get(), name, style);
    brush.fill(rest, 0.6 * u, kPlotTone);
    cairo_save(brush.cairo());
    brush.round(rest, 0.6 * u);
    cairo_clip(brush.cairo());
    Rect spectrum = rest;
    spectrum.cut_top(0.5 * u);
    paint_spectrum(brush, spectrum, widget.bars);
    cairo_restore(brush.cairo());
    // At the violet end, where most lamps have the least to show.
    if (widget.on)
        brush.mark(rest.x + 1.1 * kMarkRadius * u, rest.y + 1.1 * kMarkRadius * u, kMarkRadius * u);
}

void paint_slider(Brush& brush, const Widget& widget, const Rect& whole) {
    const double u = brush.unit();
    brush.fill(whole, kCorner * u, kTileTone);
    const PxBox box{0, 0, static_cast<int>(whole.w), static_cast<int>(whole.h)};
    const PxBox track = slider_track(box, u);
    const double y = track.top + 0.34 * track.height;
    const auto x_of = [&](double value) {
        return track.left + (brush.right_to_left() ? 1 - value : value) * track.width;
    };
    for (int i = 0; i <= 8; ++i) {
        const double height = (i == 4 ? 1.5 : i % 2 == 0 ? 1.0 : 0.6) * u;
        brush.color(i == 4 ? kWarmWhite : kSand);
        const double x = x_of(i / 8.0), wide = std::max(0.2 * u, 1.0);
        cairo_rectangle(brush.cairo(), std::round(x - wide / 2), y + 0.9 * u, wide, height);
        cairo_fill(brush.cairo());
    }
    const double value = std::isfinite(widget.value) ? std::clamp(widget.value, 0.0, 1.0) : 0.0;
    bar(brush, x_of(0), x_of(1), y, 0.8 * u, kHairline);
    bar(brush, x_of(0), x_of(value), y, 0.8 * u, kAmber);
    disc(brush, x_of(value), y, 1.7 * u, kDark);
    disc(brush, x_of(value), y, 1.45 * u, widget.on ? kAmber : kWarmWhite);
    const double pad = track.left;
    const Rect words{pad, 0.7 * u, whole.w - 2 * pad, track.top - 1.1 * u};
    brush.write(widget.text, words, {2.7, kTileTone.ink, brush.start(), Stand::middle, false, 1});
}

void paint_button(Brush& brush, const Widget& widget, const Rect& whole) {
    const double u = brush.unit();
    paint_ground(brush, whole, widget.on);
    const bool language = widget.part == Part::language;
    const TextStyle style{2.7,       kTileTone.ink,    Align::center, Stand::middle,
                          widget.on, language ? 1 : 2, language};
    Rect words = whole.inset(1.0 * u, 0.7 * u);
    if (widget.on) {
        const double radius = 1.3 * u, from_edge = 1.25 * radius;
        brush.mark(brush.right_to_left() ? whole.x + from_edge : whole.right() - from_edge,
                   whole.y + from_edge, radius);
        // One line stands below the mark, the first of two beside it.
        if (pango_layout_get_line_count(brush.set(widget.text, words.w, style.size * u, style).get()) > 1)
            words = words.inset(1.4 * u, 0);
    }
    brush.write(widget.text, words, style);
}

void paint_next(Brush& brush, const Rect& whole) {
    const double u = brush.unit();
    brush.fill(whole, kCorner * u, kLightTone);
    const double along = (brush.right_to_left() ? -1 : 1) * 0.9 * u, x = whole.middle_x(),
                 y = whole.middle_y();
    cairo_t* cairo = brush.cairo();
    cairo_move_to(cairo, x - along, y - 1.8 * u);
    cairo_line_to(cairo, x + along, y);
    cairo_line_to(cairo, x - along, y + 1.8 * u);
    brush.color(kLightTone.ink);
    cairo_set_line_width(cairo, 0.7 * u);
    cairo_set_line_cap(cairo, CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
    cairo_stroke(cairo);
}

void paint_close(Brush& brush, const Widget& widget, const Rect& whole) {
    const double u = brush.unit();
    brush.fill(whole, kCorner * u, kLightTone);
    Rect rest = whole.inset(1.4 * u, 0.6 * u);
    const Rect sign = brush.cut_start(rest, 3.4 * u);
    const double arm = 1.15 * u, x = sign.middle_x(), y = sign.middle_y();
    cairo_t* cairo = brush.cairo();
    cairo_move_to(cairo, x - arm, y - arm);
    cairo_line_to(cairo, x + arm, y + arm);
    cairo_move_to(cairo, x + arm, y - arm);
    cairo_line_to(cairo, x - arm, y + arm);
    brush.color(kLightTone.ink);
    cairo_set_line_width(cairo, 0.55 * u);
    cairo_set_line_cap(cairo, CAIRO_LINE_CAP_ROUND);
    cairo_stroke(cairo);
    brush.cut_start(rest, 0.6 * u);
    brush.write(widget.text, rest, {3.0, kLightTone.ink, Align::center, Stand::middle, true, 1});
}

} // namespace metamer
