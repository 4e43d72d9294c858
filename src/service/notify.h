// Talking to systemd (sd_notify(3)); without systemd every call does nothing.
#pragma once

#include <chrono>
#include <optional>

namespace metamer {

/// READY=1: the first frame is on the screen.
void notify_ready();
/// STATUS=running, STATUS=waiting for a screen: the line in `systemctl status`.
void notify_running();
void notify_waiting();
/// WATCHDOG=1.
void notify_alive();
/// RELOADING=1 ... READY=1 are told around a reload; STOPPING=1 before the end.
void notify_reloading();
void notify_stopping();

/// How often notify_alive() is to be called: half of WatchdogSec; none where systemd watches not.
std::optional<std::chrono::milliseconds> alive_interval();

} // namespace metamer
