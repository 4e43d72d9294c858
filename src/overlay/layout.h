// Where everything stands, for any size of screen, landscape or portrait.
#pragma once

#include <vector>

#include "overlay/box.h"
#include "overlay/widget.h"

namespace metamer {

/// Millimetres are people's: a finger needs 12, reading across a room 4 of letter height. Where the screen
/// is too small for them they shrink together; nothing ever leaves the screen.
struct ScreenSize {
    int width_px = 1280, height_px = 720;
    double px_per_mm = 4; ///< 0: unknown; then the screen is taken for 10.1 inches
};

/// What there is to lay out.
struct Contents {
    int lamps = 0; ///< tiles of the shelf
    int languages = 1;
    bool booth = false; ///< two rows of lamps
    bool panel = false, expert = false, caption = false, hint = false, notice = false;
    bool right_to_left = false;
};

struct Layout {
    PxBox scene;        ///< where the scene is drawn; overlaps no control
    double unit_px = 4; ///< a millimetre on this screen, after shrinking
    PxBox left_label, right_label;
    std::vector<PxBox> lamps, lamps_right;
    PxBox strength, mode, expert, panel, close, expert_panel, caption, hint, notice;
    std::vector<PxBox> languages;
};

/// Every box inside the screen; controls in the lower half, reachable from a wheelchair, where the screen is
/// at least 480 px high; touchable boxes do not overlap; empty boxes where Contents has nothing. Mirrored for
/// right_to_left. Holds from 320 x 240 to 4096 x 4096 px.
Layout lay_out(const ScreenSize& screen, const Contents& contents);

} // namespace metamer
