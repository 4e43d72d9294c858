// What the outside tells a running kiosk: signals and changed files, as one thing to wait for.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace metamer {

enum class Outside {
    quit,    ///< SIGTERM, SIGINT
    reload,  ///< SIGHUP
    changed, ///< a watched file was written, replaced, made or removed
};

/// Waits in a thread of its own for signals and for changes of files, and calls `tell` there: it must be
/// thread-safe (SDL_PushEvent is) and must not throw. Changes that follow each other within 100 ms are told
/// as one, 100 ms after the last (editors write, rename and truncate in steps), at most 500 ms after the
/// first. From construction to destruction, both in the same thread, SIGTERM, SIGINT and SIGHUP are blocked
/// there and told here instead (signalfd(2)); so construct it before other threads start. Move-less.
class OutsideWatch {
public:
    using Tell = std::function<void(Outside)>;

    /// Throws failure where the kernel refuses (no inotify instances left).
    explicit OutsideWatch(Tell tell);
    OutsideWatch(const OutsideWatch&) = delete;
    OutsideWatch& operator=(const OutsideWatch&) = delete;
    ~OutsideWatch();

    /// Watches these files from now on, and no others; a folder stands for all that is directly in it. Their
    /// folders are what is watched, so that a file may be replaced by rename, removed and made again, or not
    /// be there yet; symbolic links on the way are watched with what they lead to. Returns false where a
    /// folder is not there or cannot be watched: the others are, and so is the place where it would be made.
    bool watch(std::span<const std::filesystem::path> files);

private:
    class Body;
    std::unique_ptr<Body> body_;
};

} // namespace metamer
