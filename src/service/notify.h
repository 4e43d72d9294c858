// Talking to systemd (sd_notify(3)); without systemd every call does nothing.
#pragma once

#include <chrono>
#include <functional>
#include <optional>

namespace metamer {

/// READY=1: the first frame is on the screen.
void notify_ready();
/// STATUS=running, STATUS=waiting for a screen: the line in `systemctl status`.
void notify_running();
void notify_waiting();
/// RELOADING=1 ... READY=1 are told around a reload; STOPPING=1 before the end.
void notify_reloading();
void notify_stopping();

/// WATCHDOG=1, however often it is told: where systemd watches (sd_watchdog_enabled(3), asked once), and at
/// most once in a quarter of WatchdogSec. sd_notify(3) blocks while systemd is busy and its queue is full:
/// few words do not fill it.
class AliveSign {
public:
    using Clock = std::function<std::chrono::steady_clock::time_point()>;
    explicit AliveSign(Clock clock = std::chrono::steady_clock::now);

    void tell();

    /// How long to wait for the next tell() at most: half of WatchdogSec, so that no two signs are further
    /// apart than three quarters; none where systemd watches not.
    std::optional<std::chrono::milliseconds> interval() const { return interval_; }

private:
    Clock clock_;
    std::optional<std::chrono::milliseconds> interval_;
    std::chrono::steady_clock::time_point next_;
};

/// The process's own AliveSign.
void notify_alive();
std::optional<std::chrono::milliseconds> alive_interval();

} // namespace metamer
