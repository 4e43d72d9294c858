#include "service/path_watch.h"

#include <array>
#include <cerrno>
#include <climits>
#include <cstring>
#include <deque>
#include <sys/inotify.h>

#include "base/error.h"

namespace metamer {

namespace {

namespace fs = std::filesystem;

/// The kernel's own bound on links in one path (path_resolution(7)).
constexpr int kMostLinks = 40;

constexpr unsigned kItself = IN_DELETE_SELF | IN_MOVE_SELF;
/// IN_ATTRIB: permissions; IN_MODIFY puts the end of a burst off until a slow writer is done.
constexpr unsigned kNames =
    kItself | IN_CREATE | IN_DELETE | IN_MOVED_FROM | IN_MOVED_TO | IN_CLOSE_WRITE | IN_MODIFY | IN_ATTRIB;

void put_first(const fs::path& path, std::deque<std::string>& steps) {
    std::vector<std::string> parts;
    for (const fs::path& part : path)
        if (!part.empty() && part != "/" && part != ".")
            parts.push_back(part.string());
    steps.insert(steps.begin(), parts.begin(), parts.end());
}

} // namespace

PathWatch::PathWatch() : inotify_(inotify_init1(IN_NONBLOCK | IN_CLOEXEC)) {
    if (inotify_.get() < 0)
        throw failure("watch", "files", std::string("inotify_init1: ") + std::strerror(errno));
}

bool PathWatch::set(std::span<const fs::path> paths) {
    const std::lock_guard lock(mutex_);
    paths_.clear();
    for (const fs::path& path : paths) {
        std::error_code
            none_here; // the current folder was removed: the path stays relative, and is not found
        const fs::path absolute = fs::absolute(path, none_here);
        paths_.push_back(none_here ? path : absolute);
    }
    return look_again_locked();
}

bool PathWatch::look_again() {
    const std::lock_guard lock(mutex_);
    return look_again_locked();
}

bool PathWatch::look_again_locked() {
    Folders folders;
    bool all_there = true;
    for (const fs::path& path : paths_)
        all_there = follow(path, folders) && all_there;
    for (const auto& [watch, names] : folders_)
        if (!folders.contains(watch))
            inotify_rm_watch(inotify_.get(), watch); // EINVAL where its folder is gone: what is wanted
    folders_ = std::move(folders);
    return all_there;
}

/// None where the folder cannot be watched.
PathWatch::Names* PathWatch::note(const fs::path& folder, unsigned events, Folders& folders) const {
    // A folder met before in this round keeps what it is watched for; one of an earlier round does not.
    int watch = inotify_add_watch(inotify_.get(), folder.c_str(), events | IN_ONLYDIR | IN_MASK_ADD);
    if (watch >= 0 && !folders.contains(watch))
        watch = inotify_add_watch(inotify_.get(), folder.c_str(), events | IN_ONLYDIR);
    return watch < 0 ? nullptr : &folders[watch];
}

/// path_resolution(7), step by step, and a watch at each.
bool PathWatch::follow(const fs::path& path, Folders& folders) const {
    std::deque<std::string> steps;
    put_first(path, steps);
    fs::path here = "/";
    for (int links = 0; !steps.empty();) {
        const std::string name = std::move(steps.front());
        steps.pop_front();
        if (name == "..") {
            here = here.parent_path();
            continue;
        }
        std::error_code cause;
        const fs::file_status status = fs::symlink_status(here / name, cause);
        if (steps.empty() || !fs::is_directory(status)) {
            Names* names = note(here, kNames, folders);
            if (names == nullptr)
                return false;
            names->names.insert(name);
        }
        if (fs::is_symlink(status)) {
            const fs::path target = fs::read_symlink(here / name, cause);
            if (cause || ++links > kMostLinks)
                return false;
            if (target.is_absolute())
                here = "/";
            put_first(target, steps);
        } else if (fs::is_directory(status)) {
            here /= name;
            Names* names = note(here, steps.empty() ? kNames : kItself, folders);
            if (names != nullptr && steps.empty())
                names->all = true;
            if (names == nullptr && steps.empty())
                return false;
        } else {
            return steps.empty(); // the file, there or not; or what should have been a folder
        }
    }
    return true;
}

bool PathWatch::take_changes() {
    // Room for several events; one takes at most this much (inotify(7)).
    alignas(inotify_event) std::array<char, 16 * (sizeof(inotify_event) + NAME_MAX + 1)> bytes;
    bool ours = false;
    const std::lock_guard lock(mutex_);
    for (ssize_t size; (size = read(inotify_.get(), bytes.data(), bytes.size())) > 0;)
        for (ssize_t at = 0; at < size;) {
            inotify_event event{};
            std::memcpy(&event, bytes.data() + at, sizeof event);
            const char* name = bytes.data() + at + sizeof event;
            at += static_cast<ssize_t>(sizeof event + event.len);
            const auto folder = folders_.find(event.wd);
            ours |= (event.mask & IN_Q_OVERFLOW) != 0;
            if (folder == folders_.end())
                continue;
            const Names& watched = folder->second;
            ours |= (event.mask & (kItself | IN_UNMOUNT)) != 0 ||
                    (event.len > 0 && (watched.all || watched.names.contains(std::string_view(name))));
        }
    return ours;
}

} // namespace metamer
