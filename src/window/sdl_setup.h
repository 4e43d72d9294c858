// What SDL must know before it starts.
#pragma once

namespace metamer {

/// Sets SDL's hints: no signal handlers, every touch told once, no screen saver, EGL on X11 too; and keeps
/// libdbus, which SDL asks to keep the screen awake, from starting a bus where there is none. Before
/// SDL_Init.
void prepare_sdl(bool fullscreen);

} // namespace metamer
