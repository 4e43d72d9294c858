// The controls under the scene: shelf of lamps, slider, buttons.
#pragma once

#include <vector>

#include "overlay/layout.h"

namespace metamer {

/// How the controls stand, in units; heights count from the screen's lower edge upwards.
struct Controls {
    double unit_px;
    double gap;           ///< between boxes and to the screen's edges
    double tile, bar;     ///< heights of a lamp's tile and of a row of buttons
    int columns, rows;    ///< of a shelf; 0 rows without lamps
    int bar_rows;         ///< 1: all in one; 2: languages apart; 3: slider apart too
    int languages_in_row; ///< how many languages one row holds
    double height;        ///< of all of them, gaps included

    int language_rows(int languages) const;
};

/// The most comfortable arrangement that leaves the scene its half and more: the unit shrinks only where even
/// the tightest is too large.
Controls arrange_controls(const ScreenSize& screen, const Contents& contents);

/// Their boxes, left to right.
void place_controls(const Controls& controls, const ScreenSize& screen, const Contents& contents,
                    Layout& layout);

/// A box of edges in units, on whole pixels: edges that meet stay together.
PxBox px_box(double unit_px, double left, double top, double right, double bottom);

} // namespace metamer
