// Where everything stands, for any size of screen, landscape or portrait.
#pragma once

#include <vector>

#include "overlay/box.h"
#include "overlay/widget.h"

namespace metamer {

/// Millimetres are people's: a finger needs 12, reading across a room 4 of letter height. Where the screen
/// is too small for them they shrink together; nothing ever leaves the screen. Where it has few pixels to the
/// millimetre (a television) they grow, so that letters have pixels enough.
struct ScreenSize {
    int width_px = 1280, height_px = 720;
    double px_per_mm = 4; ///< 0: unknown; then the screen is taken for 10.1 inches
};

/// What there is to lay out.
struct Contents {
    int lamps = 0; ///< tiles of the shelf
    int languages = 1;
    bool booth = false; ///< a shelf under each half
    bool panel = false, expert = false, caption = false, hint = false, notice = false;
    bool right_to_left = false;
};

/// Boxes of no size stand for what is not there: nothing that Contents lacks, no mode button for fewer than
/// two lamps, no language buttons for fewer than two languages, no caption and no hint beside a panel.
struct Layout {
    PxBox scene;                   ///< where the scene is drawn; overlaps no control
    double unit_px = 4;            ///< a millimetre on this screen, after shrinking
    PxBox left_label, right_label; ///< above the scene
    std::vector<PxBox> lamps, lamps_right;
    PxBox strength, mode, expert, panel, next, close, expert_panel, caption, hint, notice;
    std::vector<PxBox> languages;
};

/// Every box inside the screen; all that can be touched in the lower half, reachable from a wheelchair; no
/// two boxes overlap, but those on the scene lie inside it and `close` inside `panel`, in its lower corner
/// (kCloseWidth x kCloseHeight units, kCloseInset from the edges), `next` beside it (kNextWidth). Mirrored
/// for right_to_left, except what belongs to a half of the scene: labels, and the booth's shelves as a whole.
/// Controls stand where they stand whatever lies over the scene. Holds from 320 x 240 to 4096 x 4096 px, for
/// up to 12 lamps and 12 languages.
Layout lay_out(const ScreenSize& screen, const Contents& contents);

inline constexpr double kCloseWidth = 22, kCloseHeight = 9, kCloseInset = 0.8, kNextWidth = 9;

/// Heights, units: two lines of words, of a notice four; and a finger's.
inline constexpr double kLabelHeight = 7, kNoticeHeight = 12.6, kHintHeight = 7, kCaptionHeight = 12;
inline constexpr double kHandleHeight = kCloseHeight;

/// The handle on the split (0 .. 1 of the scene's width), at the scene's lower edge, inside the scene; of no
/// size while a panel lies there.
PxBox split_handle(const Layout& layout, double split);

/// Where the track of a slider lies in its box, and the value 0 .. 1 of a touch at x_px there (clamped):
/// from left to right, or right to left.
PxBox slider_track(const PxBox& slider, double unit_px);
double slider_value(const PxBox& slider, double unit_px, bool right_to_left, double x_px);

} // namespace metamer
