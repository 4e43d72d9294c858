// What moves by itself: cross-fades and the shift against burn-in.
#pragma once

namespace metamer {

/// A cross-fade's whole time: under 300 ms, so that a choice feels like one's own.
inline constexpr double kFade_s = 0.25;

/// The share of the new picture `since_s` after the change: 0 at 0, 1 from kFade_s on, smooth at both ends
/// (3 t^2 - 2 t^3).
double fade(double since_s);

struct Shift {
    int x_px = 0, y_px = 0;
};

/// Where the picture stands against burn-in: a walk around a square of side 2 `most_px` about 0, one pixel a
/// minute, back at its start after a whole round. `most_px` 0: never moves.
Shift pixel_shift(double now_s, int most_px);

} // namespace metamer
