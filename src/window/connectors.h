// Screens that are plugged in and unplugged where SDL does not look again.
#pragma once

#include <filesystem>
#include <set>
#include <string>

namespace metamer {

/// What Linux says of each connector of each graphics card, in FOLDER/CONNECTOR/status: `connected`,
/// `disconnected`, or `unknown` (some panels, composite outputs, writeback). SDL 2.26 under KMSDRM draws on
/// one that was `connected` when its video started, and never asks again.
class Connectors {
public:
    /// Takes those that are connected now for those that are drawn on. No such folder: none.
    explicit Connectors(std::filesystem::path folder);

    /// Whether one of them was unplugged: says `disconnected`, or is not there any more (a dock, USB).
    bool unplugged() const;

    /// Whether any connector is `connected`: SDL finds something to draw on.
    bool connected() const;

private:
    std::string status(const std::string& connector) const;
    std::set<std::string> all_connected() const;

    std::filesystem::path folder_;
    std::set<std::string> drawn_on_;
};

} // namespace metamer
