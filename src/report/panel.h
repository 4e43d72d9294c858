// One plot inside a box of a picture.
#pragma once

#include <vector>

#include "report/canvas.h"
#include "report/plot.h"

namespace metamer {

/// A plot's frame on the picture, px.
struct PanelFrame {
    Box panel;  ///< all of it: titles, ticks, caption
    Box area;   ///< where the points are
    Box labels; ///< where labels may be: the area, and right of it where lines end in names
    AxisMap x, y;
    Ticks x_ticks, y_ticks;
    std::vector<std::string> caption; ///< lines that fit
    double em = 13;                   ///< the text's size
};

/// Throws bad_input `cannot draw the plot TITLE: ...` when the box leaves no room for it.
PanelFrame panel_frame(Canvas& canvas, const Plot& plot, const Box& panel, double em);

/// Titles, caption, regions, grid, axes and ticks: everything that lies under the points.
void draw_panel_frame(Canvas& canvas, const Plot& plot, const PanelFrame& frame);

/// The whole plot: frame, lines, points, marks, and labels that do not overlap. Gives the number of labels of
/// series, marks, lines and regions for which there was no room.
int draw_panel(Canvas& canvas, const Plot& plot, const Box& panel, double em);

} // namespace metamer
