#include "report/canvas.h"

#include <array>
#include <memory>
#include <numbers>

#include <cairo.h>

namespace metamer {

namespace {

// Debian's fonts-dejavu-core; where it is missing fontconfig gives the nearest it has.
constexpr const char* kFamily = "DejaVu Sans";

void source(cairo_t* context, Paint paint, double alpha) {
    cairo_set_source_rgba(context, paint.r, paint.g, paint.b, alpha);
}

struct FreeFontOptions {
    void operator()(cairo_font_options_t* options) const { cairo_font_options_destroy(options); }
};

} // namespace

Canvas::Canvas(_cairo* context) : context_(context) {
    // Unhinted, the text is as wide on PNG as on SVG, and a user's font settings change nothing.
    const std::unique_ptr<cairo_font_options_t, FreeFontOptions> options(cairo_font_options_create());
    cairo_font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_OFF);
    cairo_font_options_set_antialias(options.get(), CAIRO_ANTIALIAS_GRAY);
    cairo_set_font_options(context_, options.get());
    cairo_set_line_join(context_, CAIRO_LINE_JOIN_ROUND);
}

void Canvas::set(const Pen& pen) {
    source(context_, pen.paint, pen.alpha);
    cairo_set_line_width(context_, pen.width_px);
    const std::array<double, 2> dashes{4 * pen.width_px, 3 * pen.width_px};
    cairo_set_dash(context_, dashes.data(), pen.dashed ? 2 : 0, 0);
}

void Canvas::line(std::span<const Px> points, const Pen& pen) {
    if (points.empty())
        return;
    set(pen);
    cairo_move_to(context_, points.front().x, points.front().y);
    for (const Px p : points.subspan(1))
        cairo_line_to(context_, p.x, p.y);
    cairo_stroke(context_);
}

void Canvas::line(Px from, Px to, const Pen& pen) {
    line(std::array{from, to}, pen);
}

void Canvas::fill(const Box& box, Paint paint, double alpha) {
    source(context_, paint, alpha);
    cairo_rectangle(context_, box.left, box.top, box.width(), box.height());
    cairo_fill(context_);
}

void Canvas::ring(Px center, double radius, const Pen& pen) {
    set(pen);
    cairo_new_path(context_);
    cairo_arc(context_, center.x, center.y, radius, 0, 2 * std::numbers::pi);
    cairo_stroke(context_);
}

void Canvas::marker(Marker marker, bool hollow, Px center, double radius, Paint paint) {
    if (marker == Marker::none)
        return;
    cairo_new_path(context_);
    // Signs of about the same area.
    const double half = marker == Marker::square ? radius * 0.89 : radius * 1.25;
    if (marker == Marker::disc) {
        cairo_arc(context_, center.x, center.y, radius, 0, 2 * std::numbers::pi);
    } else if (marker == Marker::square) {
        cairo_rectangle(context_, center.x - half, center.y - half, 2 * half, 2 * half);
    } else {
        cairo_move_to(context_, center.x - half, center.y);
        cairo_line_to(context_, center.x, center.y - half);
        cairo_line_to(context_, center.x + half, center.y);
        cairo_line_to(context_, center.x, center.y + half);
        cairo_close_path(context_);
    }
    source(context_, hollow ? Paint{1, 1, 1} : paint, 1);
    cairo_fill_preserve(context_);
    set({hollow ? paint : Paint{1, 1, 1}, hollow ? radius * 0.38 : radius * 0.2});
    cairo_stroke(context_);
}

void Canvas::arrow(Px tip, double dx, double dy, double length, Paint paint) {
    const double side = length * 0.45;
    cairo_new_path(context_);
    cairo_move_to(context_, tip.x, tip.y);
    cairo_line_to(context_, tip.x - dx * length - dy * side, tip.y - dy * length + dx * side);
    cairo_line_to(context_, tip.x - dx * length + dy * side, tip.y - dy * length - dx * side);
    cairo_close_path(context_);
    source(context_, paint, 1);
    cairo_fill(context_);
}

void Canvas::use(const Font& font) {
    cairo_select_font_face(context_, kFamily, CAIRO_FONT_SLANT_NORMAL,
                           font.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(context_, font.size_px);
}

double Canvas::width(const std::string& text, const Font& font) {
    use(font);
    cairo_text_extents_t extents;
    cairo_text_extents(context_, text.c_str(), &extents);
    return extents.x_advance;
}

double Canvas::ascent(const Font& font) {
    use(font);
    cairo_font_extents_t extents;
    cairo_font_extents(context_, &extents);
    return extents.ascent;
}

double Canvas::line_height(const Font& font) {
    use(font);
    cairo_font_extents_t extents;
    cairo_font_extents(context_, &extents);
    return extents.ascent + extents.descent;
}

void Canvas::text(Px at, const std::string& text, const Font& font, Paint paint) {
    use(font);
    source(context_, paint, 1);
    cairo_move_to(context_, at.x, at.y);
    cairo_show_text(context_, text.c_str());
    cairo_new_path(context_);
}

void Canvas::clip(const Box& box) {
    cairo_save(context_);
    cairo_rectangle(context_, box.left, box.top, box.width(), box.height());
    cairo_clip(context_);
}

void Canvas::unclip() {
    cairo_restore(context_);
}

} // namespace metamer
