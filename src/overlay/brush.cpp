#include "overlay/brush.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace metamer {

namespace {

// Debian: fonts-dejavu-core (Latin, Greek, Arabic), fonts-vlgothic (Japanese).
constexpr const char* kFamilies = "DejaVu Sans, VL PGothic, Noto Sans";
constexpr double kPi = std::numbers::pi;
constexpr double kShrink = 0.95;

PangoAlignment pango_align(Align align) {
    return align == Align::left     ? PANGO_ALIGN_LEFT
           : align == Align::center ? PANGO_ALIGN_CENTER
                                    : PANGO_ALIGN_RIGHT;
}

PangoRectangle extents(PangoLayout* layout) {
    PangoRectangle logical;
    pango_layout_get_pixel_extents(layout, nullptr, &logical);
    return logical;
}

bool fits(PangoLayout* layout, const Rect& rect, const TextStyle& style) {
    const PangoRectangle size = extents(layout);
    return size.width <= rect.w && size.height <= rect.h &&
           pango_layout_get_line_count(layout) <= style.lines;
}

/// Errors quote whatever bytes a file held: what is no UTF-8 becomes U+FFFD, which Pango does itself, but
/// not without a word on stderr.
std::string well_formed(const std::string& bytes) {
    const std::unique_ptr<gchar, decltype(&g_free)> text(
        g_utf8_make_valid(bytes.data(), static_cast<gssize>(bytes.size())), g_free);
    return text.get();
}

/// By the first letter (Unicode UAX 9, rules P2 and P3): Hebrew, Arabic and their neighbors read from the
/// right.
bool reads_from_right(const std::string& text, bool without_letters) {
    for (const char* at = text.c_str(); *at != '\0'; at = g_utf8_next_char(at)) {
        const gunichar letter = g_utf8_get_char(at);
        if (g_unichar_isalpha(letter))
            return (letter >= 0x0590 && letter <= 0x08FF) || (letter >= 0xFB1D && letter <= 0xFEFC);
    }
    return without_letters;
}

/// As narrow as the same lines allow: the last one is no lonely word.
void balance(PangoLayout* layout) {
    const int lines = pango_layout_get_line_count(layout);
    if (lines < 2)
        return;
    int fine = pango_layout_get_width(layout), tight = fine / lines;
    while (fine - tight > PANGO_SCALE) {
        const int width = tight + (fine - tight) / 2;
        pango_layout_set_width(layout, width);
        PangoRectangle logical;
        pango_layout_get_extents(layout, nullptr, &logical);
        (pango_layout_get_line_count(layout) == lines && logical.width <= width ? fine : tight) = width;
    }
    pango_layout_set_width(layout, fine);
}

/// Where a layout narrower than its rectangle begins.
double layout_x(PangoLayout* layout, const Rect& rect, Align align) {
    const double spare = rect.w - pango_layout_get_width(layout) / static_cast<double>(PANGO_SCALE);
    return rect.x + (align == Align::left ? 0 : align == Align::center ? spare / 2 : spare);
}

} // namespace

Rect Rect::inset(double by_x, double by_y) const {
    return {x + by_x, y + by_y, std::max(w - 2 * by_x, 0.0), std::max(h - 2 * by_y, 0.0)};
}

Rect Rect::cut_top(double height) {
    height = std::min(height, h);
    const Rect top{x, y, w, height};
    y += height;
    h -= height;
    return top;
}

Rect Rect::cut_bottom(double height) {
    height = std::min(height, h);
    h -= height;
    return {x, y + h, w, height};
}

Rect Brush::cut_start(Rect& from, double width) const {
    width = std::min(width, from.w);
    const Rect part{right_to_left_ ? from.right() - width : from.x, from.y, width, from.h};
    if (!right_to_left_)
        from.x += width;
    from.w -= width;
    return part;
}

Rect Brush::cut_end(Rect& from, double width) const {
    width = std::min(width, from.w);
    const Rect part{right_to_left_ ? from.x : from.right() - width, from.y, width, from.h};
    if (right_to_left_)
        from.x += width;
    from.w -= width;
    return part;
}

void Brush::color(const Srgb& color, double alpha) const {
    cairo_set_source_rgba(cairo_, color[0] / 255.0, color[1] / 255.0, color[2] / 255.0, alpha);
}

void Brush::round(const Rect& rect, double radius) const {
    const double r = std::min({radius, rect.w / 2, rect.h / 2});
    cairo_new_sub_path(cairo_);
    cairo_arc(cairo_, rect.right() - r, rect.y + r, r, -kPi / 2, 0);
    cairo_arc(cairo_, rect.right() - r, rect.bottom() - r, r, 0, kPi / 2);
    cairo_arc(cairo_, rect.x + r, rect.bottom() - r, r, kPi / 2, kPi);
    cairo_arc(cairo_, rect.x + r, rect.y + r, r, kPi, 1.5 * kPi);
    cairo_close_path(cairo_);
}

void Brush::fill(const Rect& rect, double radius, const Tone& tone) const {
    round(rect, radius);
    color(tone.ground, tone.alpha);
    cairo_fill(cairo_);
}

void Brush::frame(const Rect& rect, double radius, const Srgb& ink, double line_px) const {
    round(rect.inset(line_px / 2), radius - line_px / 2);
    color(ink);
    cairo_set_line_width(cairo_, line_px);
    cairo_stroke(cairo_);
}

void Brush::focus(const Rect& rect, double radius) const {
    const double line_px = std::max(0.45 * unit_px_, 2.0);
    const double dash = 2.5 * line_px;
    frame(rect, radius, kDark, line_px);
    cairo_set_dash(cairo_, &dash, 1, 0);
    frame(rect, radius, {0xFF, 0xFF, 0xFF}, line_px);
    cairo_set_dash(cairo_, nullptr, 0, 0);
}

void Brush::mark(double x, double y, double radius) const {
    cairo_new_path(cairo_);
    cairo_arc(cairo_, x, y, radius, 0, 2 * kPi);
    color(kMarkTone.ground);
    cairo_fill_preserve(cairo_);
    color(kMarkTone.ink);
    cairo_set_line_width(cairo_, 0.28 * radius);
    cairo_stroke(cairo_);
    cairo_move_to(cairo_, x - 0.42 * radius, y + 0.02 * radius);
    cairo_line_to(cairo_, x - 0.10 * radius, y + 0.36 * radius);
    cairo_line_to(cairo_, x + 0.46 * radius, y - 0.34 * radius);
    cairo_set_line_cap(cairo_, CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(cairo_, CAIRO_LINE_JOIN_ROUND);
    cairo_stroke(cairo_);
}

double Brush::least_px(const TextStyle& style) const {
    constexpr double kReadable_px = 8, kLeastShare = 0.6;
    return std::min(std::max(kReadable_px, kLeastShare * style.size * unit_px_), style.size * unit_px_);
}

TextLayout Brush::set(const std::string& bytes, double width_px, double size_px,
                      const TextStyle& style) const {
    TextLayout layout(pango_cairo_create_layout(cairo_));
    const std::string text = well_formed(bytes);
    pango_layout_set_single_paragraph_mode(layout.get(), true);
    pango_layout_set_text(layout.get(), text.data(), static_cast<int>(text.size()));
    const bool rtl = style.own_direction ? reads_from_right(text, right_to_left_) : right_to_left_;
    pango_context_set_base_dir(pango_layout_get_context(layout.get()),
                               rtl ? PANGO_DIRECTION_RTL : PANGO_DIRECTION_LTR);
    pango_layout_context_changed(layout.get());
    pango_layout_set_auto_dir(layout.get(), false);
    PangoFontDescription* font = pango_font_description_from_string(kFamilies);
    pango_font_description_set_absolute_size(font, size_px * PANGO_SCALE);
    if (style.bold)
        pango_font_description_set_weight(font, PANGO_WEIGHT_BOLD);
    pango_layout_set_font_description(layout.get(), font);
    pango_font_description_free(font);
    pango_layout_set_alignment(layout.get(), pango_align(style.align));
    pango_layout_set_wrap(layout.get(), PANGO_WRAP_WORD);
    pango_layout_set_width(layout.get(), static_cast<int>(std::max(width_px, 1.0) * PANGO_SCALE));
    return layout;
}

TextLayout Brush::fitted(const std::string& text, const Rect& rect, const TextStyle& style) {
    const double full = style.size * unit_px_, least = least_px(style);
    TextStyle line = style;
    line.lines = 1;
    for (double size = full; size > std::max(least, style.one_line * full); size *= kShrink)
        if (TextLayout layout = set(text, rect.w, size, line); fits(layout.get(), rect, line))
            return layout;
    for (double size = full; size > least; size *= kShrink)
        if (TextLayout layout = set(text, rect.w, size, style); fits(layout.get(), rect, style)) {
            balance(layout.get());
            return layout;
        }
    TextLayout layout = set(text, rect.w, least, style);
    if (!fits(layout.get(), rect, style)) {
        note_cut();
        pango_layout_set_wrap(layout.get(), PANGO_WRAP_WORD_CHAR);
        pango_layout_set_ellipsize(layout.get(),
                                   style.keeps_end ? PANGO_ELLIPSIZE_MIDDLE : PANGO_ELLIPSIZE_END);
        pango_layout_set_height(layout.get(), -style.lines);
        for (int lines = style.lines; lines > 1 && extents(layout.get()).height > rect.h; --lines)
            pango_layout_set_height(layout.get(), 1 - lines);
    }
    return layout;
}

TextLayout Brush::fitted_as_bold(const std::string& text, const Rect& rect, const TextStyle& style) {
    TextStyle bold = style;
    bold.bold = true;
    TextLayout measured = fitted(text, rect, bold);
    if (style.bold)
        return measured;
    if (pango_layout_is_ellipsized(measured.get()))
        return fitted(text, rect, style);
    const int size = pango_font_description_get_size(pango_layout_get_font_description(measured.get()));
    return set(text, pango_layout_get_width(measured.get()) / static_cast<double>(PANGO_SCALE),
               size / static_cast<double>(PANGO_SCALE), style);
}

Rect Brush::place(PangoLayout* layout, const Rect& rect, const TextStyle& style) {
    const PangoRectangle size = extents(layout);
    const double spare = std::max(rect.h - size.height, 0.0);
    const double shift = style.stand == Stand::top      ? 0
                         : style.stand == Stand::middle ? std::floor(spare / 2)
                                                        : std::floor(spare);
    return {layout_x(layout, rect, style.align) + size.x, rect.y + shift, static_cast<double>(size.width),
            static_cast<double>(size.height)};
}

void Brush::write(PangoLayout* layout, const Rect& rect, const TextStyle& style) const {
    const Rect at = place(layout, rect, style);
    cairo_save(cairo_);
    cairo_rectangle(cairo_, rect.x, rect.y, rect.w, rect.h);
    cairo_clip(cairo_);
    color(style.ink);
    cairo_move_to(cairo_, layout_x(layout, rect, style.align), at.y);
    pango_cairo_show_layout(cairo_, layout);
    cairo_restore(cairo_);
}

void Brush::write(const std::string& text, const Rect& rect, const TextStyle& style) {
    if (!text.empty() && rect.w >= 1 && rect.h >= 1)
        write(fitted(text, rect, style).get(), rect, style);
}

} // namespace metamer
