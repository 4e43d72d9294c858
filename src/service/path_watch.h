// Files by their names, whatever happens to what stands behind a name.
#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "service/descriptor.h"

namespace metamer {

/// Watches paths through inotify(7): the folder that holds the name, not the file, so that the file may be
/// replaced by rename, removed and made again. Symbolic links on the way are watched as well as what they
/// lead to; folders on the way are watched for being moved or removed. One thread may read while another
/// sets.
class PathWatch {
public:
    /// Throws failure where the kernel has no inotify instance left.
    PathWatch();

    /// Watches these paths from now on, and no others; relative ones from the current folder of now. A path
    /// that is a folder stands for every name in it. Where a folder on the way is not there, the place where
    /// it would be made is watched instead. Returns whether every path's folder is there and watched.
    bool set(std::span<const std::filesystem::path> paths);

    /// Goes the same paths again: to be called after a change, which may have put other folders in their
    /// places.
    bool look_again();

    /// Takes what the kernel has to tell, without waiting; returns whether it was about a watched path.
    bool take_changes();

    /// Readable where take_changes() has something to take.
    int descriptor() const { return inotify_.get(); }

private:
    /// Names in one watched folder.
    struct Names {
        std::set<std::string, std::less<>> names;
        bool all = false;
    };
    using Folders = std::map<int, Names>; ///< by watch descriptor

    bool follow(const std::filesystem::path& path, Folders& folders) const;
    Names* note(const std::filesystem::path& folder, unsigned events, Folders& folders) const;
    bool look_again_locked();

    Descriptor inotify_;
    std::mutex mutex_; ///< guards what follows
    std::vector<std::filesystem::path> paths_;
    Folders folders_;
};

} // namespace metamer
