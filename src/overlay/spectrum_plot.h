// A spectrum filled with the colors of its wavelengths.
#pragma once

#include "overlay/brush.h"
#include "overlay/widget.h"

namespace metamer {

inline constexpr double kAxisHeight = 3.2; ///< under a plot, units

/// Fills the area under the bars, short wavelengths on the left; what is not between 0 and 1 is clamped.
void paint_spectrum(const Brush& brush, const Rect& rect, const Bars& bars);

/// The same on a ground of its own, over an axis with marks at 400, 500, 600 and 700 nm.
void paint_plot(Brush& brush, Rect rect, const Bars& bars);

} // namespace metamer
