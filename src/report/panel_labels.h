// The labels of one plot: collected while it is drawn, placed and drawn when all its ink is known.
#pragma once

#include <string>
#include <vector>

#include "report/canvas.h"
#include "report/labels.h"

namespace metamer {

/// Who chooses its place first.
enum class Rank { edge, mark, series, line, region, point };

class PanelLabels {
public:
    PanelLabels(Canvas& canvas, double em) : canvas_(canvas), em_(em) {}

    /// A label for what lies at `anchor`, drawn in a text_paint of `paint`; `second` is a line under it,
    /// smaller. Labels of the ranks edge and point stay within 2 em of their anchor. An empty text is none.
    void add(Rank rank, Px anchor, const std::string& text, Paint paint, const std::string& second = {});

    /// The name of a line at its right end: in a column there, in the order of the ends.
    void add_line_name(Px end, const std::string& text, Paint paint, const std::string& second);

    /// Ink that labels should keep off; a line as a chain of small boxes.
    void keep_off(const Box& box, double weight);
    void keep_off(Px from, Px to, double weight);

    /// Places and draws; leader lines where a label is away from its anchor. Gives the number of labels other
    /// than those of points that found no room.
    int draw(const Box& bounds);

private:
    struct Label {
        Rank rank;
        LabelWish wish;
        std::string first, second;
        Paint paint;
        bool in_column = false;
    };
    Font font(Rank rank) const;
    Font second_font() const { return {em_ * 0.75}; }
    void make_column(const Box& bounds);
    void draw_label(const Label& label, const Box& box);

    Canvas& canvas_;
    double em_;
    std::vector<Label> labels_;
    std::vector<Obstacle> obstacles_;
};

} // namespace metamer
