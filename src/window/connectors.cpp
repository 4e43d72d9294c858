#include "window/connectors.h"

#include <algorithm>
#include <fstream>

namespace metamer {

namespace fs = std::filesystem;

Connectors::Connectors(fs::path folder) : folder_(std::move(folder)), drawn_on_(all_connected()) {}

/// Empty where there is no such connector.
std::string Connectors::status(const std::string& connector) const {
    std::string word;
    std::ifstream(folder_ / connector / "status") >> word;
    return word;
}

std::set<std::string> Connectors::all_connected() const {
    std::set<std::string> connected;
    std::error_code cause;
    for (fs::directory_iterator at(folder_, cause), end; !cause && at != end; at.increment(cause))
        if (std::string name = at->path().filename(); status(name) == "connected")
            connected.insert(std::move(name));
    return connected;
}

bool Connectors::unplugged() const {
    return std::any_of(drawn_on_.begin(), drawn_on_.end(), [this](const std::string& connector) {
        const std::string now = status(connector);
        return now.empty() || now == "disconnected";
    });
}

bool Connectors::connected() const {
    return !all_connected().empty();
}

} // namespace metamer
