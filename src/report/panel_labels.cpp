#include "report/panel_labels.h"

#include <algorithm>
#include <cmath>

namespace metamer {

namespace {

constexpr double kWidest = 24; // em: longer texts are cut

} // namespace

Font PanelLabels::font(Rank rank) const {
    const bool small = rank == Rank::point || rank == Rank::edge;
    return {em_ * (small ? 0.75 : 0.9), rank == Rank::series || rank == Rank::mark};
}

void PanelLabels::add(Rank rank, Px anchor, const std::string& text, Paint paint, const std::string& second) {
    if (text.empty())
        return;
    const bool near = rank == Rank::point || rank == Rank::edge;
    Label label{.rank = rank,
                .wish = {.anchor = anchor, .farthest = near ? em_ * 2 : 0, .gap = em_ * 0.45},
                .first = canvas_.fitted(text, font(rank), kWidest * em_),
                .second = canvas_.fitted(second, second_font(), kWidest * em_),
                .paint = text_paint(paint)};
    label.wish.width = canvas_.width(label.first, font(rank));
    label.wish.height = canvas_.line_height(font(rank));
    if (!second.empty()) {
        label.wish.width = std::max(label.wish.width, canvas_.width(label.second, second_font()));
        label.wish.height += canvas_.line_height(second_font());
    }
    labels_.push_back(std::move(label));
}

void PanelLabels::add_line_name(Px end, const std::string& text, Paint paint, const std::string& second) {
    const std::size_t before = labels_.size();
    add(Rank::series, end, text, paint, second);
    if (labels_.size() > before)
        labels_.back().in_column = true;
}

void PanelLabels::make_column(const Box& bounds) {
    std::vector<Label*> column;
    double left = 0;
    for (Label& label : labels_)
        if (label.in_column) {
            column.push_back(&label);
            left = std::max(left, label.wish.anchor.x + em_ * 0.6);
        }
    std::stable_sort(column.begin(), column.end(),
                     [](const Label* a, const Label* b) { return a->wish.anchor.y < b->wish.anchor.y; });
    std::vector<Stretch> stretches;
    for (const Label* label : column)
        stretches.push_back({label->wish.anchor.y, label->wish.height + em_ * 0.2});
    const auto tops = spread_out(stretches, bounds.top, bounds.bottom);
    for (std::size_t i = 0; i < column.size(); ++i) {
        LabelWish& wish = column[i]->wish;
        const double top = tops[i] + em_ * 0.1;
        wish.wanted = Box{left, top, left + wish.width, top + wish.height};
    }
}

void PanelLabels::keep_off(const Box& box, double weight) {
    obstacles_.push_back({box, weight});
}

void PanelLabels::keep_off(Px from, Px to, double weight) {
    const double step = em_ * 0.5;
    const int pieces = std::max(1, static_cast<int>(std::hypot(to.x - from.x, to.y - from.y) / step));
    for (int i = 0; i <= pieces; ++i) {
        const double t = static_cast<double>(i) / pieces;
        obstacles_.push_back(
            {around({from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)}, step / 2), weight});
    }
}

void PanelLabels::draw_label(const Label& label, const Box& box) {
    const Px anchor = label.wish.anchor, end = nearest_point(box, anchor);
    const double dx = end.x - anchor.x, dy = end.y - anchor.y, distance = std::hypot(dx, dy);
    if (distance > em_ * 1.1) {
        // It ends at the marker's rim, not in its middle.
        const double part = em_ * 0.4 / distance;
        canvas_.line({anchor.x + dx * part, anchor.y + dy * part}, end, {label.paint, em_ * 0.06, 0.7});
    }
    const Font first = font(label.rank);
    // Beside the anchor on its left, lines end at it.
    const bool right_aligned = box.right <= anchor.x;
    const auto left = [&](const std::string& text, const Font& f) {
        return right_aligned ? box.right - canvas_.width(text, f) : box.left;
    };
    canvas_.fill(box, {1, 1, 1}, 0.72);
    canvas_.text({left(label.first, first), box.top + canvas_.ascent(first)}, label.first, first,
                 label.paint);
    if (!label.second.empty())
        canvas_.text({left(label.second, second_font()),
                      box.top + canvas_.line_height(first) + canvas_.ascent(second_font())},
                     label.second, second_font(), kFaded);
}

int PanelLabels::draw(const Box& bounds) {
    make_column(bounds);
    std::stable_sort(labels_.begin(), labels_.end(),
                     [](const Label& a, const Label& b) { return a.rank < b.rank; });
    std::vector<LabelWish> wishes;
    for (const Label& label : labels_)
        wishes.push_back(label.wish);
    const auto places = place_labels(wishes, obstacles_, bounds);
    int left_out = 0;
    for (std::size_t i = 0; i < labels_.size(); ++i) {
        if (places[i])
            draw_label(labels_[i], *places[i]);
        else
            left_out += labels_[i].rank != Rank::point;
    }
    return left_out;
}

} // namespace metamer
