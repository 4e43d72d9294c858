#include "service/notify.h"

#include <algorithm>
#include <string>
#include <systemd/sd-daemon.h>
#include <time.h>

namespace metamer {

namespace {

/// What systemd does not take is no reason to stop: the result says only that.
void tell(const std::string& state) {
    sd_notify(0, state.c_str());
}

} // namespace

void notify_ready() {
    tell("READY=1");
}

void notify_running() {
    tell("STATUS=running");
}

void notify_waiting() {
    tell("STATUS=waiting for a screen");
}

void notify_alive() {
    tell("WATCHDOG=1");
}

void notify_reloading() {
    // Type=notify-reload (systemd 253) takes RELOADING=1 only with its time.
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    const auto usec = static_cast<long long>(now.tv_sec) * 1'000'000 + now.tv_nsec / 1000;
    tell("RELOADING=1\nMONOTONIC_USEC=" + std::to_string(usec));
}

void notify_stopping() {
    tell("STOPPING=1");
}

std::optional<std::chrono::milliseconds> alive_interval() {
    std::uint64_t within_usec = 0;
    if (sd_watchdog_enabled(0, &within_usec) <= 0)
        return std::nullopt;
    return std::max(std::chrono::milliseconds(1), std::chrono::duration_cast<std::chrono::milliseconds>(
                                                      std::chrono::microseconds(within_usec / 2)));
}

} // namespace metamer
