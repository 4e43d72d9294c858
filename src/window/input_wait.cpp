#include "window/input_wait.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <linux/major.h>
#include <linux/netlink.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>

#include "base/error.h"

namespace metamer {

namespace {

namespace fs = std::filesystem;

constexpr double kRest_s = 0.01, kLongest_s = 1e6;
/// How long input may wait where nothing tells of it.
constexpr double kBlind_s = 0.05;

int option(int socket, int name) {
    int value = -1;
    socklen_t size = sizeof value;
    return getsockopt(socket, SOL_SOCKET, name, &value, &size) == 0 ? value : -1;
}

} // namespace

bool brings_input(int descriptor) {
    struct stat about {};
    if (fstat(descriptor, &about) != 0)
        return false;
    if (S_ISSOCK(about.st_mode))
        return option(descriptor, SO_DOMAIN) == AF_NETLINK &&
               option(descriptor, SO_PROTOCOL) == NETLINK_KOBJECT_UEVENT;
    return S_ISCHR(about.st_mode) && major(about.st_rdev) == INPUT_MAJOR;
}

InputWait::InputWait(std::function<bool(int)> is_input)
    : is_input_(std::move(is_input)), wake_(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {
    if (wake_.get() < 0)
        throw failure("wait", "for input", std::string("eventfd: ") + std::strerror(errno));
}

void InputWait::wake() {
    const std::uint64_t one = 1;
    // It fails only where it is readable already.
    [[maybe_unused]] const ssize_t written = write(wake_.get(), &one, sizeof one);
}

void InputWait::find() {
    polled_.assign(1, {wake_.get(), POLLIN, 0});
    std::error_code cause;
    for (fs::directory_iterator at("/proc/self/fd", cause), end; !cause && at != end; at.increment(cause))
        if (const int descriptor = std::atoi(at->path().filename().c_str()); is_input_(descriptor))
            polled_.push_back({descriptor, POLLIN, 0});
}

bool InputWait::sleep(double most_s) {
    if (stale_)
        find();
    const bool rests = rests_, blind = polled_.size() == 1;
    const double least_s = std::min(most_s, rests ? kRest_s : blind ? kBlind_s : kLongest_s);
    // Rounded up: a rest below a millisecond is not to be waited for in circles.
    const auto least_ms = static_cast<int>(std::ceil(least_s * 1e3));
    const int ready = poll(polled_.data(), rests ? 1 : polled_.size(), least_ms);
    const auto any_input = [this](int what) {
        return std::any_of(polled_.begin() + 1, polled_.end(),
                           [what](const pollfd& input) { return (input.revents & what) != 0; });
    };
    rests_ = !rests && any_input(~0);
    stale_ = !rests && (ready <= 0 || any_input(~POLLIN));
    std::uint64_t woken = 0;
    [[maybe_unused]] const ssize_t drained = read(wake_.get(), &woken, sizeof woken);
    return ready > 0;
}

} // namespace metamer
