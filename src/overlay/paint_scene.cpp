#include <algorithm>
#include <cmath>

#include "overlay/widget_paint.h"

namespace metamer {

namespace {

/// A text on a ground no wider than itself; at the side that the style says, or in the middle.
void paint_words(Brush& brush, const std::string& text, const Rect& whole, const TextStyle& style,
                 double pad_units, bool framed) {
    const double u = brush.unit(), pad = pad_units * u;
    const Rect room = whole.inset(pad, 0.6 * u);
    const TextLayout layout = brush.fitted(text, room, style);
    const Rect at = Brush::place(layout.get(), room, style);
    Rect ground{at.x - pad, at.y - 0.9 * u, at.w + 2 * pad, at.h + 1.8 * u};
    ground.y = std::max(ground.y, whole.y);
    ground.h = std::min(ground.h, whole.bottom() - ground.y);
    ground.x = std::floor(std::max(ground.x, whole.x));
    ground.w = std::min(std::ceil(ground.w), whole.right() - ground.x);
    brush.fill(ground, kCorner * u, kLabelTone);
    if (framed)
        brush.frame(ground, kCorner * u, kAmber, std::max(0.3 * u, 1.0));
    brush.write(layout.get(), room, style);
}

void triangle(const Brush& brush, double tip_x, double y, double reach) {
    cairo_t* cairo = brush.cairo();
    cairo_move_to(cairo, tip_x, y);
    cairo_line_to(cairo, tip_x - reach, y - std::abs(reach));
    cairo_line_to(cairo, tip_x - reach, y + std::abs(reach));
    cairo_close_path(cairo);
    cairo_fill(cairo);
}

} // namespace

void paint_half_label(Brush& brush, const Widget& widget, const Rect& whole) {
    // It belongs to a half, whatever the language: at that half's edge, with an arrow to it.
    const bool left = widget.part == Part::left_label;
    const double u = brush.unit(), arrow = 3.6 * u;
    const TextStyle style{3.0, kLabelTone.ink, left ? Align::left : Align::right, Stand::middle, false, 2};
    Rect room = whole.inset(1.2 * u, 0.5 * u);
    room.w -= arrow;
    if (left)
        room.x += arrow;
    const TextLayout layout = brush.fitted(widget.text, room, style);
    const Rect at = Brush::place(layout.get(), room, style);
    const double width = std::min(std::ceil(at.w + arrow + 2.6 * u), whole.w);
    const Rect ground{left ? whole.x : whole.right() - width, whole.y, width, whole.h};
    brush.fill(ground, kCorner * u, kLabelTone);
    brush.color(kAmber);
    triangle(brush, left ? whole.x + 1.3 * u : whole.right() - 1.3 * u, whole.middle_y(),
             left ? -1.3 * u : 1.3 * u);
    brush.write(layout.get(), room, style);
}

void paint_handle(Brush& brush, const Rect& whole) {
    const double u = brush.unit();
    const Rect grip = whole.inset(0.8 * u, 0.6 * u);
    brush.fill(grip, grip.h / 2, kLightTone);
    brush.frame(grip, grip.h / 2, kDark, std::max(0.35 * u, 1.0));
    brush.color(kLightTone.ink);
    triangle(brush, grip.x + 1.3 * u, grip.middle_y(), -1.7 * u);
    triangle(brush, grip.right() - 1.3 * u, grip.middle_y(), 1.7 * u);
    const double wide = std::max(0.5 * u, 2.0);
    cairo_rectangle(brush.cairo(), std::round(grip.middle_x() - wide / 2), grip.y + 1.6 * u, wide,
                    grip.h - 3.2 * u);
    cairo_fill(brush.cairo());
}

void paint_caption(Brush& brush, const Widget& widget, const Rect& whole) {
    paint_words(brush, widget.text, whole, {4.0, kLabelTone.ink, Align::center, Stand::middle, false, 2}, 2.6,
                false);
}

void paint_hint(Brush& brush, const Widget& widget, const Rect& whole) {
    paint_words(brush, widget.text, whole, {3.2, kLabelTone.ink, Align::center, Stand::middle, false, 2}, 2.4,
                true);
}

void paint_notice(Brush& brush, const Widget& widget, const Rect& whole) {
    const double u = brush.unit(), pad = 0.6 * u;
    TextStyle style{2.4, kNoticeTone.ink, brush.start(), Stand::middle, false, 4};
    style.keeps_end = true;
    Rect rest = whole.inset(1.2 * u, pad);
    Rect sign = brush.cut_start(rest, 5.2 * u);
    brush.cut_start(rest, 0.8 * u);
    const TextLayout layout = brush.fitted(widget.text, rest, style);
    // No larger than what it says, and its sign.
    rest.h = sign.h = std::min(rest.h, std::max(Brush::place(layout.get(), rest, style).h, 5 * u));
    brush.fill({whole.x, whole.y, whole.w, std::min(rest.h + 2 * pad, whole.h)}, kCorner * u, kNoticeTone);
    cairo_t* cairo = brush.cairo();
    const double x = sign.middle_x(), y = sign.middle_y(), arm = 2.1 * u;
    cairo_move_to(cairo, x, y - arm);
    cairo_line_to(cairo, x + 1.1 * arm, y + 0.85 * arm);
    cairo_line_to(cairo, x - 1.1 * arm, y + 0.85 * arm);
    cairo_close_path(cairo);
    brush.color(kNoticeTone.ink);
    cairo_set_line_width(cairo, 0.4 * u);
    cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
    cairo_stroke(cairo);
    brush.write("!", {x - arm, y - 0.75 * arm, 2 * arm, 1.6 * arm},
                {2.2, kNoticeTone.ink, Align::center, Stand::middle, true, 1});
    brush.write(layout.get(), rest, style);
}

} // namespace metamer
