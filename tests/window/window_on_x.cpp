#include "window/window_on_x.h"

#include <GLES2/gl2.h>
#include <SDL.h>
#include <SDL_syswm.h>
#include <chrono>
#include <thread>

namespace metamer::test {

void show_color(Stage& stage, float red, float green, float blue) {
    stage.bind();
    glClearColor(red, green, blue, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    stage.show();
}

unsigned long x_window() {
    SDL_SysWMinfo info{};
    SDL_VERSION(&info.version);
    SDL_GetWindowWMInfo(SDL_GetWindowFromID(1), &info);
    return info.info.x11.window;
}

std::unique_ptr<Stage> WindowOnX::open(const WindowOptions& options) {
    std::unique_ptr<Stage> stage = open_window(options);
    // In the middle of the screen, where every window here is. The server maps when it likes.
    for (int i = 0; i < 1000 && screen_->pixel(160, 120) != std::array{255, 0, 255}; ++i) {
        show_color(*stage, 1, 0, 1);
        stage->wait(0.01);
    }
    stage->wait(0);
    return stage;
}

} // namespace metamer::test
