// Shapes and words on one widget's picture.
#pragma once

#include <cairo.h>
#include <memory>
#include <pango/pangocairo.h>
#include <string>

#include "overlay/theme.h"

namespace metamer {

/// A part of the picture, px.
struct Rect {
    double x = 0, y = 0, w = 0, h = 0;

    double right() const { return x + w; }
    double bottom() const { return y + h; }
    double middle_x() const { return x + w / 2; }
    double middle_y() const { return y + h / 2; }
    Rect inset(double by) const { return inset(by, by); }
    Rect inset(double by_x, double by_y) const;
    /// What is left of it besides the part cut off there, which is returned.
    Rect cut_top(double height);
    Rect cut_bottom(double height);
};

enum class Align { left, center, right };
enum class Stand { top, middle, bottom };

/// How a text is set. `size`: of the letters' em, units; the text shrinks from there.
struct TextStyle {
    double size = 2.6;
    Srgb ink = kWarmWhite;
    Align align = Align::center;
    Stand stand = Stand::middle;
    bool bold = false;
    int lines = 2;              ///< at most
    bool own_direction = false; ///< by its own letters, not by the widget's language
    double one_line = 1;        ///< letters shrink to this share of their size rather than stand in two lines
    bool keeps_end = false;     ///< what does not fit is left out before the last words, not of them
};

struct FreeLayout {
    void operator()(PangoLayout* layout) const { g_object_unref(layout); }
};
using TextLayout = std::unique_ptr<PangoLayout, FreeLayout>;

class Brush {
public:
    /// `right_to_left`: of the widget's words.
    Brush(cairo_t* cairo, double unit_px, bool right_to_left)
        : cairo_(cairo), unit_px_(unit_px), right_to_left_(right_to_left) {}

    cairo_t* cairo() const { return cairo_; }
    double unit() const { return unit_px_; }
    bool right_to_left() const { return right_to_left_; }
    Align start() const { return right_to_left_ ? Align::right : Align::left; }
    /// Cuts off the side where reading starts, or ends.
    Rect cut_start(Rect& from, double width) const;
    Rect cut_end(Rect& from, double width) const;

    void color(const Srgb& color, double alpha = 1) const;
    void round(const Rect& rect, double radius) const; ///< a path with round corners
    void fill(const Rect& rect, double radius, const Tone& tone) const;
    void frame(const Rect& rect, double radius, const Srgb& ink, double line_px) const;
    /// What has the keyboard: dashes inside the box, light on dark on whatever it is.
    void focus(const Rect& rect, double radius) const;
    /// A tick in a disc of kMarkTone: chosen.
    void mark(double x, double y, double radius) const;

    /// A text as large as it fits into the rectangle, at most as its style says; in the smallest letters
    /// with an ellipsis, which text_cut() tells.
    TextLayout fitted(const std::string& text, const Rect& rect, const TextStyle& style);
    /// The same, set as its bold letters would be, bold or not: a name stays where it is when it is chosen.
    TextLayout fitted_as_bold(const std::string& text, const Rect& rect, const TextStyle& style);
    /// The text in letters of `size_px`, broken at this width.
    TextLayout set(const std::string& text, double width_px, double size_px, const TextStyle& style) const;
    /// Where it stands in the rectangle.
    static Rect place(PangoLayout* layout, const Rect& rect, const TextStyle& style);
    void write(PangoLayout* layout, const Rect& rect, const TextStyle& style) const;
    void write(const std::string& text, const Rect& rect, const TextStyle& style);

    /// The smallest letters for a style, px.
    double least_px(const TextStyle& style) const;
    void note_cut() { cut_ = true; }
    bool text_cut() const { return cut_; }

private:
    cairo_t* cairo_;
    double unit_px_;
    bool right_to_left_;
    bool cut_ = false;
};

} // namespace metamer
