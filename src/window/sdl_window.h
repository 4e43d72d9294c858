// SDL's video, one window on it, one OpenGL ES 2 context in that.
#pragma once

#include <SDL.h>
#include <memory>
#include <string>
#include <vector>

#include "window/reset_context.h"
#include "window/rotation.h"
#include "window/stage.h"

namespace metamer {

/// The video drivers to try, in order: those of SDL_VIDEODRIVER (parted by commas), else all that this SDL
/// was built with and that end on a screen.
std::vector<std::string> video_drivers();

/// All of it or nothing; one at a time, as SDL's video is the process's own. The context is the thread's
/// current one. Needs SDL's events (SDL_INIT_EVENTS).
class SdlWindow {
public:
    /// By the first of video_drivers() that gives window and context. Throws no_gl: `cannot open a window:
    /// DRIVER: CAUSE; DRIVER: CAUSE`.
    static std::unique_ptr<SdlWindow> open(const WindowOptions& options);

    /// The same by one driver, which must live on. Throws std::string: the cause.
    SdlWindow(const char* driver, const WindowOptions& options);
    SdlWindow(const SdlWindow&) = delete;
    SdlWindow& operator=(const SdlWindow&) = delete;
    ~SdlWindow() = default;

    PxSize surface_size() const; ///< of the framebuffer
    PxSize window_size() const;  ///< in SDL's coordinates
    /// As the display says, or from its size in pixels and its diagonal in inches if that is not 0.
    double px_per_mm(double diagonal_in) const;

    /// Waits for vsync where the display gives one. False: the context is lost (EGL_CONTEXT_LOST).
    bool show();

    /// Makes sure that the context is current. False: it cannot be, nor come back.
    bool keep_current() const { return !reset_ || reset_->keep_current(); }

private:
    struct Video {
        explicit Video(const char* driver);
        Video(const Video&) = delete;
        Video& operator=(const Video&) = delete;
        ~Video() { SDL_VideoQuit(); }
    };
    struct DeleteContext {
        void operator()(void* context) const { SDL_GL_DeleteContext(context); }
    };
    struct DestroyWindow {
        void operator()(SDL_Window* window) const { SDL_DestroyWindow(window); }
    };

    // In the order in which they are made.
    Video video_;
    std::unique_ptr<SDL_Window, DestroyWindow> window_;
    std::unique_ptr<void, DeleteContext> context_;
    std::unique_ptr<ResetContext> reset_;
};

} // namespace metamer
