// `metamer chart --growth`: what makes a frame cost more.
#pragma once

#include "exhibit/exhibit.h"
#include "report/growth_rows.h"

namespace metamer {

/// Sweeps one thing at a time by every method, rgb-pow and planned among them; each panel's frames are timed
/// in interleaved rounds of their own (frame_timing.h). The display is the exhibit's; its scene is not: a
/// panel is
///   wavelengths: a still-life whose ball carries 8 materials; `reduced` at every N, the loops at their 64,
///     planned with spectra of 8 .. 64 samples;
///   lamps: the same under 1 .. 8 lamps of different spectra, without shadows;
///   materials: one lamp, 1 .. 63 materials on the ball;
///   objects: a loaf of 1 .. 63 slices, each of a material of its own, the same pixels;
///   pixels: the still-life from 160x90 to the exhibit's width at 16:9.
/// What cannot be drawn is left out, with its cause in ChartContext::left_out. Needs a current context.
Growth measure_growth(const Display& display, int rounds);

} // namespace metamer
