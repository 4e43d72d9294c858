// Events as text, to be compared at a glance.
#pragma once

#include <sstream>
#include <string>
#include <vector>

#include "window/events.h"

namespace metamer::test {

/// `down 0 100.5 50.5`, `key left`, `resize 640x480`, `quit`, ...
class EventText {
public:
    std::string operator()(const PointerEvent& e) const {
        constexpr const char* phases[] = {"down", "move", "up", "cancel"};
        std::ostringstream text;
        text << phases[static_cast<int>(e.phase)] << ' ' << e.finger << ' ' << e.x_px << ' ' << e.y_px;
        return text.str();
    }
    std::string operator()(const KeyEvent& e) const {
        constexpr const char* keys[] = {"left", "right", "up", "down", "enter", "escape", "tab", "back_tab"};
        return std::string("key ") + keys[static_cast<int>(e.key)];
    }
    std::string operator()(const ResizeEvent& e) const {
        return "resize " + std::to_string(e.width_px) + "x" + std::to_string(e.height_px);
    }
    std::string operator()(const ExposeEvent&) const { return "expose"; }
    std::string operator()(const ContextLostEvent&) const { return "context lost"; }
    std::string operator()(const DisplayGoneEvent&) const { return "display gone"; }
    std::string operator()(const DisplayBackEvent&) const { return "display back"; }
    std::string operator()(const QuitEvent&) const { return "quit"; }
    std::string operator()(const ReloadEvent&) const { return "reload"; }
    std::string operator()(const FilesChangedEvent&) const { return "files changed"; }
};

inline std::vector<std::string> texts(const std::vector<Event>& events) {
    std::vector<std::string> all;
    for (const Event& event : events)
        all.push_back(std::visit(EventText(), event));
    return all;
}

} // namespace metamer::test
