#include "report/panel.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "report/panel_labels.h"

namespace metamer {

namespace {

constexpr Paint kReference{0.45, 0.45, 0.48};
constexpr Paint kRefused{0.65, 0.29, 0.0};

// Draws what lies in one frame, and collects its labels.
class PanelPainter {
public:
    PanelPainter(Canvas& canvas, const Plot& plot, const PanelFrame& frame)
        : canvas_(canvas), plot_(plot), frame_(frame), em_(frame.em), labels_(canvas, frame.em) {}

    int draw() {
        canvas_.clip(frame_.area);
        for (const ReferenceLine& line : plot_.lines)
            draw_reference(line);
        for (const bool faint : {true, false})
            for (const Series& series : plot_.series)
                if (series.faint == faint)
                    draw_line(series);
        canvas_.unclip();
        for (const bool faint : {true, false})
            for (const Series& series : plot_.series)
                if (series.faint == faint)
                    draw_points(series);
        for (const Mark& mark : plot_.marks)
            draw_mark(mark);
        for (const Region& region : plot_.regions)
            label_region(region);
        return labels_.draw(frame_.labels);
    }

private:
    struct Spot {
        Px at;
        int beyond_x, beyond_y;
        bool nan; // no y: `at` is the upper end
    };

    Spot spot(double x, double y, const std::string& what) const {
        if (std::isnan(x))
            throw bad_input("draw", what.empty() ? plot_.title : what, "a point has no x");
        const Place px = frame_.x(x);
        if (std::isnan(y))
            return {{px.at, frame_.area.top}, px.beyond, 0, true};
        const Place py = frame_.y(y);
        return {{px.at, py.at}, px.beyond, py.beyond, false};
    }

    double radius(const Series& series) const { return em_ * (series.faint ? 0.2 : 0.33); }

    void draw_reference(const ReferenceLine& line) {
        const Box& area = frame_.area;
        const bool level = line.at == ReferenceLine::At::y;
        const double at = (level ? frame_.y(line.value) : frame_.x(line.value)).at;
        const Px from = level ? Px{area.left, at} : Px{at, area.bottom};
        const Px to = level ? Px{area.right, at} : Px{at, area.top};
        canvas_.line(from, to, {kReference, em_ * 0.1, 1, true});
        labels_.keep_off(from, to, 0.7);
        labels_.add(Rank::line, to, line.label, kReference);
    }

    void draw_line(const Series& series) {
        if (series.stroke == Stroke::none)
            return;
        const bool steps = series.stroke == Stroke::steps;
        const Pen pen{.paint = series_paint(series.color),
                      .width_px = em_ * (steps          ? 0.4
                                         : series.faint ? 0.09
                                                        : 0.16),
                      .alpha = steps          ? 0.4
                               : series.faint ? 0.55
                                              : 0.9,
                      .dashed = series.stroke == Stroke::dashed};
        std::vector<Px> run;
        const auto finish = [&] {
            if (run.size() > 1)
                canvas_.line(run, pen);
            for (std::size_t i = 1; i < run.size(); ++i)
                labels_.keep_off(run[i - 1], run[i], series.faint ? 1 : 1.5);
            run.clear();
        };
        for (const PlotPoint& point : series.points) {
            const Spot s = spot(point.x, point.y, series.label);
            if (s.nan) {
                finish();
                continue;
            }
            if (series.stroke == Stroke::steps && !run.empty())
                run.push_back({s.at.x, run.back().y});
            run.push_back(s.at);
        }
        finish();
    }

    // A bar with its tick and an end cap; the part off the axis is left away, the point's own arrow tells.
    void draw_bar(Px at, const Spread& spread, bool upright, const Series& series) {
        const Paint paint = series_paint(series.color);
        const double low = (upright ? frame_.y(spread.low) : frame_.x(spread.low)).at;
        const double high = (upright ? frame_.y(spread.high) : frame_.x(spread.high)).at;
        const auto point = [&](double along, double aside) {
            return upright ? Px{at.x + aside, along} : Px{along, at.y + aside};
        };
        const double alpha = series.faint ? 0.35 : series.hollow ? 0.45 : 0.6;
        const Pen pen{paint, em_ * 0.1, alpha};
        canvas_.line(point(low, 0), point(high, 0), pen);
        canvas_.line(point(high, -em_ * 0.26), point(high, em_ * 0.26), pen);
        if (spread.tick) {
            const double tick = (upright ? frame_.y(*spread.tick) : frame_.x(*spread.tick)).at;
            canvas_.line(point(tick, -em_ * 0.17), point(tick, em_ * 0.17), pen);
        }
        labels_.keep_off(point(low, 0), point(high, 0), 2);
    }

    void draw_edge(const Spot& s, double y, Paint paint) {
        const double length = em_ * 0.55;
        const Box& area = frame_.area;
        if (s.beyond_x != 0)
            canvas_.arrow({s.at.x, std::clamp(s.at.y, area.top, area.bottom)}, s.beyond_x, 0, length, paint);
        if (s.beyond_y != 0) {
            const double down = s.at.y == area.bottom ? 1 : -1;
            canvas_.arrow(s.at, 0, down, length, paint);
        }
        if (s.nan) {
            const double arm = em_ * 0.3;
            const Px c{s.at.x, s.at.y + arm};
            canvas_.line({c.x - arm, c.y - arm}, {c.x + arm, c.y + arm}, {paint, em_ * 0.16});
            canvas_.line({c.x - arm, c.y + arm}, {c.x + arm, c.y - arm}, {paint, em_ * 0.16});
        }
        const std::string word = s.nan ? "NaN" : std::isinf(y) ? "∞" : y == 0 && s.beyond_y < 0 ? "0" : "";
        labels_.add(Rank::edge, s.at, word, paint);
    }

    // The first point, or the one farthest to the right that has a place.
    Px named_end(const Series& series) const {
        Spot end = spot(series.points.front().x, series.points.front().y, series.label);
        for (const PlotPoint& point : series.points)
            if (const Spot s = spot(point.x, point.y, series.label);
                !series.label_first && !s.nan && (end.nan || s.at.x >= end.at.x))
                end = s;
        return end.at;
    }

    void draw_points(const Series& series) {
        const Paint paint = series_paint(series.color);
        for (const PlotPoint& point : series.points) {
            const Spot s = spot(point.x, point.y, series.label);
            if (point.x_spread)
                draw_bar(s.at, *point.x_spread, false, series);
            if (point.y_spread && !s.nan)
                draw_bar(s.at, *point.y_spread, true, series);
            if (s.nan || s.beyond_x != 0 || s.beyond_y != 0)
                draw_edge(s, point.y, paint);
            else
                canvas_.marker(series.marker, series.hollow, s.at, radius(series), paint);
            if (series.marker != Marker::none)
                labels_.keep_off(around(s.at, em_ * 0.4), 4);
            labels_.add(Rank::point, s.at, point.label, paint);
        }
        if (series.points.empty())
            return;
        const Px end = named_end(series);
        const bool at_the_right = end.x > frame_.area.right - 0.2 * frame_.area.width();
        if (series.stroke != Stroke::none && !series.label_first && at_the_right)
            labels_.add_line_name(end, series.label, paint, series.second_line);
        else
            labels_.add(Rank::series, end, series.label, paint, series.second_line);
    }

    void draw_mark(const Mark& mark) {
        const Spot s = spot(mark.x, mark.y, mark.word);
        const double r = em_ * 0.75;
        canvas_.ring(s.at, r, {{1, 1, 1}, em_ * 0.36, 0.9});
        canvas_.ring(s.at, r, {kInk, em_ * 0.15});
        labels_.keep_off(around(s.at, r), 4);
        labels_.add(Rank::mark, s.at, mark.word, series_paint(mark.color));
    }

    // In the upper middle of the shaded part.
    void label_region(const Region& region) {
        const Box& area = frame_.area;
        const double x0 = region.x_low ? frame_.x(*region.x_low).at : area.left;
        const double x1 = region.x_high ? frame_.x(*region.x_high).at : area.right;
        const double y0 = region.y_low ? frame_.y(*region.y_low).at : area.bottom;
        const double y1 = region.y_high ? frame_.y(*region.y_high).at : area.top;
        labels_.add(Rank::region, {(x0 + x1) / 2, std::min(y0, y1) + std::abs(y1 - y0) / 4}, region.label,
                    kRefused);
    }

    Canvas& canvas_;
    const Plot& plot_;
    const PanelFrame& frame_;
    double em_;
    PanelLabels labels_;
};

} // namespace

int draw_panel(Canvas& canvas, const Plot& plot, const Box& panel, double em) {
    const PanelFrame frame = panel_frame(canvas, plot, panel, em);
    draw_panel_frame(canvas, plot, frame);
    return PanelPainter(canvas, plot, frame).draw();
}

} // namespace metamer
