// How large a pixel is.
#pragma once

namespace metamer {

/// Pixels per millimetre of a screen of this size and diagonal (inches); 0 where the diagonal is 0.
double px_per_mm_of_diagonal(int width_px, int height_px, double diagonal_in);

/// Pixels per millimetre from what a display says of itself in dots per inch, across and down. Displays say
/// an aspect ratio for a size, a size of 0, or their maker's favorite number: 0 (nobody knows) unless both
/// agree within a tenth and lie in 1 .. 30 px/mm.
double px_per_mm_of_dpi(double horizontal_dpi, double vertical_dpi);

} // namespace metamer
