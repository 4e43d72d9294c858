#include "window/sdl_setup.h"

#include <SDL.h>
#include <cstdlib>
#include <filesystem>

namespace metamer {

namespace {

/// Over what the environment says.
void must(const char* hint, const char* value) {
    SDL_SetHintWithPriority(hint, value, SDL_HINT_OVERRIDE);
}

/// dbus-launch, which libdbus would call, leaves a daemon and a file behind.
void start_no_bus() {
    const char* runtime = std::getenv("XDG_RUNTIME_DIR");
    std::error_code ignored;
    if (runtime == nullptr || !std::filesystem::exists(std::filesystem::path(runtime) / "bus", ignored))
        setenv("DBUS_SESSION_BUS_ADDRESS", "disabled:", 0);
}

} // namespace

void prepare_sdl(bool fullscreen) {
    must(SDL_HINT_NO_SIGNAL_HANDLERS, "1");        // signals are OutsideWatch's
    must(SDL_HINT_QUIT_ON_LAST_WINDOW_CLOSE, "0"); // the window's own event says that already
    must(SDL_HINT_TOUCH_MOUSE_EVENTS, "0");        // a touch is not told a second time as a mouse
    must(SDL_HINT_MOUSE_TOUCH_EVENTS, "0");
    must(SDL_HINT_VIDEO_ALLOW_SCREENSAVER, "0");
    must(SDL_HINT_VIDEO_MINIMIZE_ON_FOCUS_LOSS, "0");
    must(SDL_HINT_VIDEO_X11_NET_WM_BYPASS_COMPOSITOR, fullscreen ? "1" : "0");
    must(SDL_HINT_VIDEO_X11_FORCE_EGL, "1"); // the GLES that is linked here is EGL's
    must(SDL_HINT_VIDEO_WAYLAND_ALLOW_LIBDECOR, fullscreen ? "0" : "1"); // no frame, no frame's library
    SDL_SetHint(SDL_HINT_APP_NAME, "Metamer");
    start_no_bus();
}

} // namespace metamer
