#include "window/x_screen.h"

#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <csignal>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

#include "commands/process.h"

namespace metamer::test {

namespace {

/// A second client of the server that DISPLAY names.
class Client {
public:
    Client() : display_(XOpenDisplay(nullptr), XCloseDisplay) {
        if (!display_)
            throw std::runtime_error("cannot reach the X server");
    }
    Display* get() const { return display_.get(); }

private:
    std::unique_ptr<Display, int (*)(Display*)> display_;
};

/// Up to the line break, or the end.
std::string read_line(int descriptor) {
    std::string line;
    for (char letter; read(descriptor, &letter, 1) == 1 && letter != '\n';)
        line += letter;
    return line;
}

Shot part_of(Display* display, int left, int top, int width_px, int height_px) {
    const std::unique_ptr<XImage, void (*)(XImage*)> image(
        XGetImage(display, DefaultRootWindow(display), left, top, static_cast<unsigned>(width_px),
                  static_cast<unsigned>(height_px), AllPlanes, ZPixmap),
        [](XImage* old) { XDestroyImage(old); });
    Shot shot{width_px, height_px};
    for (int y = 0; y < height_px; ++y)
        for (int x = 0; x < width_px; ++x) {
            const unsigned long rgb = XGetPixel(image.get(), x, y);
            shot.pixels.push_back({static_cast<int>(rgb >> 16 & 255), static_cast<int>(rgb >> 8 & 255),
                                   static_cast<int>(rgb & 255)});
        }
    return shot;
}

} // namespace

std::string missing(const std::string& program, const std::string& package) {
    if (run_program("/usr/bin/env", {"which", program}).status == 0)
        return {};
    return program + " is missing: apt-get install " + package;
}

std::string missing_for_x() {
    const std::string server = missing("Xvfb", "xvfb");
    return server.empty() ? missing("xdotool", "xdotool") : server;
}

XScreen::XScreen(int width_px, int height_px) {
    const std::string size = std::to_string(width_px) + "x" + std::to_string(height_px) + "x24";
    int ends[2] = {};
    if (pipe(ends) != 0)
        throw std::runtime_error("no pipe to be had");
    const std::string told = std::to_string(ends[1]);
    server_ = fork();
    if (server_ == 0) {
        prctl(PR_SET_PDEATHSIG, SIGKILL);
        close(ends[0]);
        execlp("Xvfb", "Xvfb", "-displayfd", told.c_str(), "-screen", "0", size.c_str(), "-nolisten", "tcp",
               "-noreset", nullptr);
        _exit(127);
    }
    close(ends[1]);
    const std::string number = read_line(ends[0]);
    close(ends[0]);
    if (number.empty())
        throw std::runtime_error("Xvfb does not start");
    setenv("DISPLAY", (":" + number).c_str(), 1);
    setenv("SDL_VIDEODRIVER", "x11", 1);
    unsetenv("WAYLAND_DISPLAY");
}

XScreen::~XScreen() {
    kill(server_, SIGTERM);
    waitpid(server_, nullptr, 0);
    unsetenv("DISPLAY");
    unsetenv("SDL_VIDEODRIVER");
}

void XScreen::act(std::initializer_list<std::string> words) const {
    std::vector<std::string> arguments{"xdotool"};
    arguments.insert(arguments.end(), words);
    const Outcome outcome = run_program("/usr/bin/env", arguments);
    if (outcome.status != 0)
        throw std::runtime_error("xdotool: " + outcome.err);
}

std::array<int, 3> XScreen::pixel(int x, int y) const {
    return part_of(Client().get(), x, y, 1, 1).at(0, 0);
}

Shot XScreen::shot() const {
    const Client client;
    return part_of(client.get(), 0, 0, DisplayWidth(client.get(), 0), DisplayHeight(client.get(), 0));
}

void XScreen::ask_to_close(unsigned long window) const {
    const Client client;
    XEvent event{};
    event.xclient.type = ClientMessage;
    event.xclient.window = window;
    event.xclient.message_type = XInternAtom(client.get(), "WM_PROTOCOLS", False);
    event.xclient.format = 32;
    event.xclient.data.l[0] = static_cast<long>(XInternAtom(client.get(), "WM_DELETE_WINDOW", False));
    XSendEvent(client.get(), window, False, NoEventMask, &event);
    XFlush(client.get());
}

} // namespace metamer::test
