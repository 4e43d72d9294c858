// What a picture of plots shows: plain data, drawn by picture.h.
//
// Texts are UTF-8; what is not, and control characters, are drawn as `?`, and what is too long ends in `…`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "report/axis.h"
#include "report/palette.h"

namespace metamer {

enum class Marker { none, disc, square, diamond };
enum class Stroke {
    none,
    solid,
    dashed,
    steps
}; ///< steps: level to the next point, then up or down; broad and light

/// A bar from low to high with a tick across it; in the axis's unit.
struct Spread {
    double low = 0, high = 0;
    std::optional<double> tick{};
};

/// Infinities and values off the axis are drawn at its end with an arrow, zero on a log10 axis as `0` there,
/// NaN as a cross at the upper end; none breaks a picture.
struct PlotPoint {
    double x = 0, y = 0;
    std::optional<Spread> x_spread{}, y_spread{};
    std::string label{}; ///< beside the point where there is room
};

struct Series {
    std::string label{};       ///< at its right end, or with `label_first` at the first point
    std::string second_line{}; ///< under the label, small
    std::vector<PlotPoint> points{};
    int color = 0; ///< of series_paint
    Stroke stroke = Stroke::solid;
    Marker marker = Marker::disc;
    bool hollow = false;
    bool label_first = false;
    bool faint = false; ///< drawn under all others, thin and light
};

/// A ring and a word around a point that matters.
struct Mark {
    double x = 0, y = 0;
    std::string word{};
    int color = 0;
};

/// A line across the plot at a value of x or y.
struct ReferenceLine {
    enum class At { x, y } at = At::y;
    double value = 0;
    std::string label{};
};

/// A shaded part; an end that is not set is the plot's own.
struct Region {
    std::optional<double> x_low{}, x_high{}, y_low{}, y_high{};
    std::string label{};
};

struct Plot {
    std::string title{};
    std::string caption{}; ///< under the plot, wrapped
    Axis x{}, y{};
    std::vector<Series> series{};
    std::vector<Mark> marks{};
    std::vector<ReferenceLine> lines{};
    std::vector<Region> regions{};
};

/// One sign explained above the plots: a marker, a marker with its bar and tick, or a line.
struct KeyItem {
    enum class Sign { marker, bar, line } sign = Sign::marker;
    Marker marker = Marker::disc;
    bool hollow = false;
    std::string text{};
};

/// Plots in a grid, row by row, under one title.
struct Picture {
    std::string title{};
    std::string subtitle{};               ///< one sentence: what to see
    std::string note{};                   ///< the corner: GL renderer, date, command
    int width_px = 1200, height_px = 800; ///< 320x240 .. 4096x4096
    int columns = 1;
    std::vector<Plot> plots{};
    std::vector<KeyItem> key{};
};

} // namespace metamer
