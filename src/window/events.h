// What people do at the screen, in the picture's own pixels: rotation is taken out.
#pragma once

#include <variant>

namespace metamer {

enum class PointerPhase { down, move, up, cancel };

/// A finger, or the mouse with its left button (finger 0).
struct PointerEvent {
    PointerPhase phase;
    int finger;
    double x_px, y_px; ///< from the upper left corner of the picture as people see it
};

enum class Key { left, right, up, down, enter, escape, tab, back_tab };

struct KeyEvent {
    Key key;
};

/// The picture's size as people see it (width and height exchanged at 90 and 270 degrees).
struct ResizeEvent {
    int width_px, height_px;
};

/// What stood on the screen may be lost (uncovered, display back): show the frame again.
struct ExposeEvent {};

/// The GL context is gone with all that it held.
struct ContextLostEvent {};

/// The display went away, or came back: no frame can be shown between. Where the window must be made anew for
/// it to come back (KMSDRM), ContextLostEvent says so, and the new window tells.
struct DisplayGoneEvent {};
struct DisplayBackEvent {};

/// From OutsideWatch or the window's close button.
struct QuitEvent {};
struct ReloadEvent {};
struct FilesChangedEvent {};

using Event = std::variant<PointerEvent, KeyEvent, ResizeEvent, ExposeEvent, ContextLostEvent,
                           DisplayGoneEvent, DisplayBackEvent, QuitEvent, ReloadEvent, FilesChangedEvent>;

} // namespace metamer
