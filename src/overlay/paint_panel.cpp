#include <algorithm>
#include <array>
#include <cmath>

#include "overlay/layout.h"
#include "overlay/spectrum_plot.h"
#include "overlay/widget_paint.h"

namespace metamer {

namespace {

void paint_ground(const Brush& brush, const Rect& whole) {
    const double u = brush.unit();
    brush.fill(whole, kCorner * u, kPanelTone);
    brush.frame(whole, kCorner * u, kHairline, std::max(0.25 * u, 1.0));
}

void paint_sign(const Brush& brush, const Rect& at, bool times) {
    const double arm = 1.3 * brush.unit(), x = at.middle_x(), y = at.middle_y();
    cairo_t* cairo = brush.cairo();
    const double slant = times ? arm : -0.5 * arm;
    // Times: two diagonals; equals: two level lines.
    cairo_move_to(cairo, x - arm, times ? y - arm : y + slant);
    cairo_line_to(cairo, x + arm, y + slant);
    cairo_move_to(cairo, x - arm, times ? y + arm : y - slant);
    cairo_line_to(cairo, x + arm, y - slant);
    brush.color(kPanelTone.ink);
    cairo_set_line_width(cairo, 0.55 * brush.unit());
    cairo_set_line_cap(cairo, CAIRO_LINE_CAP_ROUND);
    cairo_stroke(cairo);
}

/// lamp × material = product, in the order of reading.
void paint_plots(Brush& brush, const ProductPanel& product, Rect rest) {
    const double u = brush.unit(), sign = 5 * u;
    const double width = (rest.w - 2 * sign) / 3;
    const double name = std::clamp(0.24 * rest.h, 5.2 * u, 6.6 * u);
    const std::array<std::pair<const std::string*, const Bars*>, 3> plots{
        {{&product.lamp_name, &product.lamp},
         {&product.material_name, &product.material},
         {&product.product_name, &product.product}}};
    for (std::size_t i = 0; i < plots.size(); ++i) {
        Rect plot = brush.cut_start(rest, width);
        const Rect words = plot.cut_top(name);
        brush.write(*plots[i].first, words, {2.6, kPanelTone.ink, Align::center, Stand::middle, false, 2});
        plot.cut_top(0.5 * u);
        paint_plot(brush, plot, *plots[i].second);
        if (i + 1 < plots.size()) {
            Rect between = brush.cut_start(rest, sign);
            between.cut_top(name);
            between.cut_bottom(kAxisHeight * u);
            paint_sign(brush, between, i == 0);
        }
    }
}

/// The two colors edge to edge, so that a difference shows, each over its name. Left stays left: they are
/// the scene's halves.
void paint_fields(Brush& brush, const ProductPanel& product, Rect rest) {
    const double u = brush.unit();
    Rect names = rest.cut_bottom(std::clamp(0.45 * rest.h, 5.8 * u, 6.5 * u));
    names.cut_top(0.4 * u);
    const double half = std::floor(rest.w / 2);
    cairo_t* cairo = brush.cairo();
    cairo_save(cairo);
    brush.round(rest, 0.8 * u);
    cairo_clip(cairo);
    brush.color(product.left);
    cairo_rectangle(cairo, rest.x, rest.y, half, rest.h);
    cairo_fill(cairo);
    brush.color(product.right);
    cairo_rectangle(cairo, rest.x + half, rest.y, rest.w - half, rest.h);
    cairo_fill(cairo);
    cairo_restore(cairo);
    brush.frame(rest, 0.8 * u, kHairline, std::max(0.2 * u, 1.0));
    const TextStyle style{2.3, kPanelTone.faded, Align::center, Stand::top, false, 2};
    brush.write(product.left_name, {names.x, names.y, half - 0.5 * u, names.h}, style);
    brush.write(product.right_name, {names.x + half + 0.5 * u, names.y, rest.w - half - 0.5 * u, names.h},
                style);
}

/// Name and value of one row, in letters of one size.
struct Row {
    TextLayout name, value;
    double height = 0;
};

constexpr double kNameShare = 0.3, kColumnGap = 1.6, kRowGap = 0.7;

std::vector<Row> set_rows(const Brush& brush, const ExpertPanel& expert, double width, double size_px,
                          const TextStyle& name, const TextStyle& value) {
    std::vector<Row> rows;
    const double name_width = kNameShare * width;
    const double value_width = width - name_width - kColumnGap * brush.unit();
    for (const auto& [title, text] : expert.rows) {
        Row row{brush.set(title, name_width, size_px, name), brush.set(text, value_width, size_px, value)};
        for (PangoLayout* layout : {row.name.get(), row.value.get()}) {
            pango_layout_set_wrap(layout, PANGO_WRAP_WORD_CHAR);
            int height = 0;
            pango_layout_get_pixel_size(layout, nullptr, &height);
            row.height = std::max<double>(row.height, height);
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

double height_of(const std::vector<Row>& rows, double gap) {
    double height = -gap;
    for (const Row& row : rows)
        height += row.height + gap;
    return height;
}

void write_rows(Brush& brush, const std::vector<Row>& rows, Rect rest, const TextStyle& name,
                const TextStyle& value) {
    for (const Row& row : rows) {
        if (row.height > rest.h + 0.5) {
            brush.note_cut();
            return;
        }
        Rect line = rest.cut_top(row.height);
        const Rect name_at = brush.cut_start(line, kNameShare * rest.w);
        brush.cut_start(line, kColumnGap * brush.unit());
        brush.write(row.name.get(), name_at, name);
        brush.write(row.value.get(), line, value);
        rest.cut_top(kRowGap * brush.unit());
    }
}

} // namespace

void paint_product(Brush& brush, const ProductPanel& product, const Rect& whole) {
    const double u = brush.unit();
    paint_ground(brush, whole);
    const double pad = (whole.h < 44 * u ? 1.2 : 2.2) * u;
    Rect rest = whole.inset(1.2 * pad, pad);
    const Rect title = rest.cut_top(std::clamp(0.09 * whole.h, 4.2 * u, 6 * u));
    brush.write(product.title, title, {3.6, kPanelTone.ink, brush.start(), Stand::middle, true, 1});
    rest.cut_top(0.4 * pad);
    Rect below = rest.cut_bottom(std::clamp(0.3 * whole.h, 10.8 * u, 19 * u));
    rest.cut_bottom(0.6 * pad);
    paint_plots(brush, product, rest);
    paint_fields(brush, product, brush.cut_start(below, std::clamp(0.38 * below.w, 34 * u, 62 * u)));
    brush.cut_start(below, 2.2 * u);
    // The widgets `close` and `next` have that corner (layout.h).
    constexpr double kCorner_units = kCloseWidth + kNextWidth + 2 * kCloseInset;
    brush.cut_end(below, std::max(kCorner_units * u - 1.2 * pad, 0.0) + 1.6 * u);
    const Rect words = below.cut_top(0.62 * below.h);
    below.cut_top(0.6 * u);
    brush.write(product.difference, words, {3.4, kPanelTone.ink, brush.start(), Stand::bottom, true, 3});
    brush.write(product.number, below, {2.8, kPanelTone.faded, brush.start(), Stand::top, false, 1});
}

void paint_expert(Brush& brush, const ExpertPanel& expert, const std::string& title, const Rect& whole) {
    const double u = brush.unit();
    Rect rest = whole.inset(2 * u, 1.4 * u);
    const Rect head = rest.cut_top(4.4 * u);
    rest.cut_top(0.8 * u);
    const TextStyle name{2.5, kPanelTone.faded, brush.start(), Stand::top, false, 99};
    TextStyle value = name;
    value.ink = kPanelTone.ink;
    value.own_direction = true;
    const double least = brush.least_px(name);
    std::vector<Row> rows;
    for (double size = name.size * u;; size = std::max(size * 0.95, least)) {
        rows = set_rows(brush, expert, rest.w, size, name, value);
        if (size <= least || height_of(rows, kRowGap * u) <= rest.h)
            break;
    }
    // No larger than what it says.
    const double bottom = rest.y + height_of(rows, kRowGap * u) + 1.6 * u;
    paint_ground(brush, {whole.x, whole.y, whole.w, std::min(whole.h, bottom - whole.y)});
    brush.write(title, head, {2.9, kPanelTone.ink, brush.start(), Stand::middle, true, 1});
    write_rows(brush, rows, rest, name, value);
}

} // namespace metamer
