// Where the kiosk plays: a surface with an OpenGL ES 2 context, events, a clock.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "window/events.h"

namespace metamer {

class Stage {
public:
    virtual ~Stage() = default;

    /// The events since the last call, kept until the next; waits for the first of them, `most_s` at most (0:
    /// does not wait, negative: forever). While there is no display it goes on waiting for one.
    virtual const std::vector<Event>& wait(double most_s) = 0;

    /// Wakes wait(), from any thread, with this event (quit, reload, files changed).
    virtual void post(const Event& event) = 0;

    /// The framebuffer's own size: what glViewport takes, before rotation.
    virtual int surface_width_px() const = 0;
    virtual int surface_height_px() const = 0;

    /// How the picture is turned on the surface, clockwise: 0, 90, 180, 270.
    virtual int rotation_deg() const = 0;

    /// Pixels per millimetre of the screen; 0 where nobody knows.
    virtual double px_per_mm() const = 0;

    /// From now on the screen hangs so, and is as large: what WindowOptions say of both. What is told from
    /// now on is turned so.
    virtual void hang(int rotation_deg, double diagonal_in) = 0;

    /// Binds the framebuffer that show() shows, its viewport all of it.
    virtual void bind() = 0;

    /// Shows what was drawn there; waits for vsync where the display gives one.
    virtual void show() = 0;

    /// Whether the context must be made anew: it was reset (GL_EXT_robustness, GL_KHR_robustness), cannot be
    /// made current any more, or its screen was gone meanwhile.
    virtual bool context_lost() = 0;

    /// Makes window and context anew: after a loss. Every GL object made before is gone and must have been
    /// destroyed or abandoned by its owner already. A size that came out different is wait()'s to tell.
    /// Returns false where it waited for a display and WindowOptions::still_waiting gave up: there is nothing
    /// to draw on then. Throws no_gl.
    virtual bool rebuild() = 0;

    /// Seconds of a steady clock.
    virtual double now_s() const = 0;

    /// `KMSDRM`, `wayland`, `x11`, `surfaceless`: for the log.
    virtual std::string driver() const = 0;
};

struct WindowOptions {
    int width_px = 0, height_px = 0; ///< of the window; 0: full screen
    int rotation_deg = 0;            ///< clockwise
    double diagonal_in = 0;          ///< of the screen; 0: as the display says
    bool wait_for_display = false;   ///< where there is no display: wait for one instead of throwing
    /// Asked ten times a second while that waits, with the last try's error (a try a second); false: gives
    /// up. The place to tell systemd that the process is alive.
    std::function<bool(const std::string& error)> still_waiting{};
    std::string title = "Metamer";
};

/// By SDL2: KMSDRM, Wayland, X11, whatever SDL finds (SDL_VIDEODRIVER chooses). Throws no_gl: `cannot open a
/// window: DRIVER: CAUSE; DRIVER: CAUSE` with what was tried. Returns none where still_waiting gave up. One
/// at a time, for the thread that made it; SDL installs no signal handlers, and neither sound nor joysticks.
std::unique_ptr<Stage> open_window(const WindowOptions& options);

} // namespace metamer
