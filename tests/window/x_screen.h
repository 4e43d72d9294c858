// An X server of the test's own, and hands and eyes on it.
#pragma once

#include <array>
#include <initializer_list>
#include <string>
#include <sys/types.h>
#include <vector>

namespace metamer::test {

/// Empty where `program` is in PATH; else a sentence that names Debian's package of it.
std::string missing(const std::string& program, const std::string& package);

/// The same of what XScreen needs.
std::string missing_for_x();

/// All that stood on the screen at one moment.
struct Shot {
    int width_px = 0, height_px = 0;
    std::vector<std::array<int, 3>> pixels{}; ///< red, green, blue; rows from the top

    const std::array<int, 3>& at(int x, int y) const {
        return pixels.at(static_cast<std::size_t>(y * width_px + x));
    }
};

/// Xvfb with one screen, from construction to destruction; DISPLAY and SDL_VIDEODRIVER lead there, and no
/// Wayland does.
class XScreen {
public:
    XScreen(int width_px, int height_px);
    XScreen(const XScreen&) = delete;
    XScreen& operator=(const XScreen&) = delete;
    ~XScreen();

    /// xdotool with these words.
    void act(std::initializer_list<std::string> words) const;
    /// What stands there on the screen: red, green, blue.
    std::array<int, 3> pixel(int x, int y) const;
    Shot shot() const;
    /// What a window manager's close button does.
    void ask_to_close(unsigned long window) const;

private:
    pid_t server_;
};

} // namespace metamer::test
