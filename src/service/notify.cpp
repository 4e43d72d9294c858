#include "service/notify.h"

#include <algorithm>
#include <string>
#include <systemd/sd-daemon.h>
#include <time.h>
#include <utility>

namespace metamer {

namespace {

/// What systemd does not take is no reason to stop: the result says only that.
void notify(const std::string& state) {
    sd_notify(0, state.c_str());
}

} // namespace

void notify_ready() {
    notify("READY=1");
}

void notify_running() {
    notify("STATUS=running");
}

void notify_waiting() {
    notify("STATUS=waiting for a screen");
}

void notify_reloading() {
    // Type=notify-reload (systemd 253) takes RELOADING=1 only with its time.
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    const auto usec = static_cast<long long>(now.tv_sec) * 1'000'000 + now.tv_nsec / 1000;
    notify("RELOADING=1\nMONOTONIC_USEC=" + std::to_string(usec));
}

void notify_stopping() {
    notify("STOPPING=1");
}

AliveSign::AliveSign(Clock clock) : clock_(std::move(clock)), next_(clock_()) {
    std::uint64_t within_usec = 0;
    if (sd_watchdog_enabled(0, &within_usec) > 0)
        interval_ =
            std::max(std::chrono::milliseconds(1), std::chrono::duration_cast<std::chrono::milliseconds>(
                                                       std::chrono::microseconds(within_usec / 2)));
}

void AliveSign::tell() {
    const auto now = clock_();
    if (!interval_ || now < next_)
        return;
    next_ = now + *interval_ / 2;
    notify("WATCHDOG=1");
}

namespace {

AliveSign& own_sign() {
    static AliveSign sign;
    return sign;
}

} // namespace

void notify_alive() {
    own_sign().tell();
}

std::optional<std::chrono::milliseconds> alive_interval() {
    return own_sign().interval();
}

} // namespace metamer
