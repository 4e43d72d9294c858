#include "window/sdl_window.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>

#include "base/error.h"
#include "base/names.h"
#include "gles/keep_mapped.h"
#include "window/density.h"

namespace metamer {

namespace {

std::string value_of(const char* variable) {
    const char* value = std::getenv(variable);
    return value == nullptr ? "" : value;
}

std::string said(const char* variable) {
    const std::string value = value_of(variable);
    return variable + (value.empty() ? std::string(" is not set") : "=" + value);
}

/// SDL says no more than that a driver is not available: what it would need, as it is here.
std::string circumstance(std::string_view driver) {
    std::error_code ignored;
    if (driver == "x11")
        return ", " + said("DISPLAY");
    if (driver == "wayland")
        return ", " + said("WAYLAND_DISPLAY");
    if (same_name(driver, "KMSDRM") && !std::filesystem::exists("/dev/dri", ignored))
        return ", no /dev/dri";
    return {};
}

/// What makes a try pointless: libwayland would say so itself, on stderr, at every try.
std::string missing(std::string_view driver) {
    return driver == "wayland" && !value_of("WAYLAND_DISPLAY").starts_with('/') &&
                   value_of("XDG_RUNTIME_DIR").empty()
               ? "XDG_RUNTIME_DIR is not set"
               : "";
}

[[noreturn]] void refuse(const std::string& doing) {
    throw doing + SDL_GetError();
}

void set_attributes(int red, int green, int blue) {
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_ES);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 2);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, 0);
    SDL_GL_SetAttribute(SDL_GL_RED_SIZE, red);
    SDL_GL_SetAttribute(SDL_GL_GREEN_SIZE, green);
    SDL_GL_SetAttribute(SDL_GL_BLUE_SIZE, blue);
    SDL_GL_SetAttribute(SDL_GL_ALPHA_SIZE, 0);
    SDL_GL_SetAttribute(SDL_GL_DEPTH_SIZE, 16);
    SDL_GL_SetAttribute(SDL_GL_STENCIL_SIZE, 0);
    SDL_GL_SetAttribute(SDL_GL_DOUBLEBUFFER, 1);
}

SDL_Window* make_window(const WindowOptions& options) {
    const bool fullscreen = options.width_px == 0;
    const auto flags = SDL_WINDOW_OPENGL | SDL_WINDOW_ALLOW_HIGHDPI |
                       (fullscreen ? SDL_WINDOW_FULLSCREEN_DESKTOP : SDL_WINDOW_RESIZABLE);
    const int centered = static_cast<int>(SDL_WINDOWPOS_CENTERED);
    SDL_Rect place{centered, centered, options.width_px, options.height_px};
    // Without a window manager (X alone) a full screen is where and as large as it was made.
    if (fullscreen && SDL_GetDisplayBounds(0, &place) != 0)
        return nullptr;
    return SDL_CreateWindow(options.title.c_str(), place.x, place.y, place.w, place.h,
                            static_cast<Uint32>(flags));
}

} // namespace

std::vector<std::string> video_drivers() {
    if (const char* chosen = std::getenv("SDL_VIDEODRIVER"); chosen != nullptr && *chosen != '\0')
        return split(chosen, ',');
    std::vector<std::string> drivers;
    for (int i = 0; i < SDL_GetNumVideoDrivers(); ++i) {
        const std::string driver = SDL_GetVideoDriver(i);
        // These show nothing to anybody, and SDL would fall back on them without a word.
        if (driver != "offscreen" && driver != "dummy" && driver != "evdev")
            drivers.push_back(driver);
    }
    return drivers;
}

std::unique_ptr<SdlWindow> SdlWindow::open(const WindowOptions& options) {
    std::string causes;
    for (const std::string& driver : video_drivers()) {
        try {
            if (const std::string cause = missing(driver); !cause.empty())
                throw cause;
            return std::make_unique<SdlWindow>(driver.c_str(), options);
        } catch (const std::string& cause) {
            causes += (causes.empty() ? "" : "; ") + driver + ": " + cause + circumstance(driver);
        }
    }
    throw no_gl("open", "a window", causes.empty() ? "this SDL has no video driver" : causes);
}

SdlWindow::Video::Video(const char* driver) {
    if (SDL_VideoInit(driver) != 0)
        refuse("");
    // SDL starts with an input method (over D-Bus); nobody types text here.
    SDL_StopTextInput();
}

SdlWindow::SdlWindow(const char* driver, const WindowOptions& options) : video_(driver) {
    set_attributes(8, 8, 8);
    window_.reset(make_window(options));
    if (!window_) {
        set_attributes(5, 6, 5);
        window_.reset(make_window(options));
    }
    if (!window_)
        refuse("no window: ");
    context_.reset(SDL_GL_CreateContext(window_.get()));
    if (!context_)
        refuse("no OpenGL ES 2 context: ");
    reset_ = ResetContext::in_place_of_current();
    keep_libraries_mapped();
    // Where the display gives no vsync, frames are shown at once.
    SDL_GL_SetSwapInterval(1);
}

PxSize SdlWindow::surface_size() const {
    PxSize size;
    SDL_GL_GetDrawableSize(window_.get(), &size.width_px, &size.height_px);
    return size;
}

PxSize SdlWindow::window_size() const {
    PxSize size;
    SDL_GetWindowSize(window_.get(), &size.width_px, &size.height_px);
    return size;
}

double SdlWindow::px_per_mm(double diagonal_in) const {
    const int display = SDL_GetWindowDisplayIndex(window_.get());
    SDL_DisplayMode mode{};
    if (display < 0 || SDL_GetDesktopDisplayMode(display, &mode) != 0)
        return 0;
    if (diagonal_in > 0) {
        // The desktop's size is in its own coordinates where it scales.
        const double scale =
            static_cast<double>(surface_size().width_px) / std::max(window_size().width_px, 1);
        return px_per_mm_of_diagonal(mode.w, mode.h, diagonal_in) * scale;
    }
    float diagonal_dpi = 0, horizontal_dpi = 0, vertical_dpi = 0;
    if (SDL_GetDisplayDPI(display, &diagonal_dpi, &horizontal_dpi, &vertical_dpi) != 0)
        return 0;
    return px_per_mm_of_dpi(static_cast<double>(horizontal_dpi), static_cast<double>(vertical_dpi));
}

bool SdlWindow::show() {
    SDL_ClearError();
    SDL_GL_SwapWindow(window_.get());
    // SDL 2 gives no other word of it.
    return std::string_view(SDL_GetError()).find("EGL_CONTEXT_LOST") == std::string_view::npos;
}

} // namespace metamer
