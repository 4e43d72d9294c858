// Asleep until something is touched, where SDL can only be asked (KMSDRM).
#pragma once

#include <functional>
#include <poll.h>
#include <vector>

#include "service/descriptor.h"

namespace metamer {

/// Whether SDL reads input from this open descriptor: an input device (evdev), or what udev tells of devices
/// that come and go (netlink(7), NETLINK_KOBJECT_UEVENT).
bool brings_input(int descriptor);

/// SDL 2.26 hides the descriptors that it reads under KMSDRM, but /proc/self/fd lists them. They are waited
/// for and never read: that is SDL's. Where there is none, each sleep is short, and SDL is to be asked then.
class InputWait {
public:
    /// Throws failure where the kernel has no descriptor left.
    explicit InputWait(std::function<bool(int)> is_input = brings_input);

    /// Returns true with input or after wake(), false after `most_s` or earlier. Of input that nobody reads
    /// it tells a hundred times a second at most.
    bool sleep(double most_s);

    /// Ends the sleep() of another thread; the next one, where none is going on.
    void wake();

private:
    void find();

    std::function<bool(int)> is_input_;
    Descriptor wake_;            ///< eventfd(2)
    std::vector<pollfd> polled_; ///< wake_, then input
    bool stale_ = true;          ///< SDL may have opened and closed some
    bool rests_ = false;         ///< input ended the last sleep
};

} // namespace metamer
