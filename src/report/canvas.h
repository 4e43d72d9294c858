// A surface to draw on, the same strokes for SVG and PNG. Cairo stays behind this header.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "report/geometry.h"
#include "report/palette.h"
#include "report/plot.h"

struct _cairo;

namespace metamer {

struct Font {
    double size_px = 13;
    bool bold = false;
};

struct Pen {
    Paint paint = kInk;
    double width_px = 1;
    double alpha = 1;
    bool dashed = false;
};

/// The text as it can be drawn: what is not UTF-8 and control characters as `?`.
std::string drawable(std::string_view text);

class Canvas {
public:
    /// Borrows the context.
    explicit Canvas(_cairo* context);

    void line(std::span<const Px> points, const Pen& pen);
    void line(Px from, Px to, const Pen& pen);
    void fill(const Box& box, Paint paint, double alpha = 1);
    void ring(Px center, double radius, const Pen& pen);
    /// A sign of about 2 * radius; hollow: its outline, white inside.
    void marker(Marker marker, bool hollow, Px center, double radius, Paint paint);
    /// A small arrow whose tip is at `tip`, pointing along (dx, dy), which is a unit vector.
    void arrow(Px tip, double dx, double dy, double length, Paint paint);

    /// The advance of the text, px; the same on SVG and PNG. `text` is drawable.
    double width(const std::string& text, const Font& font);
    /// Ascent and height of a line, px.
    double ascent(const Font& font);
    double line_height(const Font& font);
    /// Draws drawable text; `at` is the left end of its baseline.
    void text(Px at, const std::string& text, const Font& font, Paint paint);

    /// drawable text, cut at a code point and ended by `…` where it would be wider than `most` px.
    std::string fitted(std::string_view text, const Font& font, double most);
    /// drawable text in lines of at most `most` px, broken at blanks; at most `lines`, the last one cut.
    std::vector<std::string> wrapped(std::string_view text, const Font& font, double most, std::size_t lines);

    /// What follows is drawn inside the box only, until `unclip`.
    void clip(const Box& box);
    void unclip();

private:
    void set(const Pen& pen);
    void use(const Font& font);

    _cairo* context_;
};

} // namespace metamer
