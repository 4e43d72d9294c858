// A whole kiosk on a surfaceless stage: events are posted, time is told, frames are read.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "color/transfer.h"
#include "kiosk/exhibits.h"
#include "kiosk/kiosk.h"
#include "methods/shade.h"
#include "render/pick.h"
#include "window/surfaceless_stage.h"

namespace metamer {

struct TestScreen {
    int width_px = 640, height_px = 480, rotation_deg = 0;
    double px_per_mm = 0;
};

class TestKiosk {
public:
    explicit TestKiosk(const std::string& first = patches(), const TestScreen& screen = {})
        : text(first),
          stage(screen.width_px, screen.height_px, screen.rotation_deg, screen.px_per_mm),
          kiosk(parts()) {}

    KioskParts parts() {
        KioskParts parts;
        parts.stage = &stage;
        parts.log = &log;
        parts.load = [this] {
            ++loads;
            in_loading();
            return std::make_unique<Loaded>(Loaded{edit(kiosk_exhibit(text)), all_words()});
        };
        parts.minute_of_day = [this] {
            in_the_turn();
            return minute;
        };
        parts.describe = [this](const std::string& now) { described = now; };
        return parts;
    }

    bool turn() { return kiosk.turn(0); }
    bool turn(const Event& event) {
        stage.post(event);
        return turn();
    }
    /// Lets the fade end.
    void settle() {
        turn();
        while (kiosk.show().fading(stage.now_s())) {
            stage.advance(0.05);
            turn();
        }
        turn();
    }
    /// A finger at a place of the picture, in two turns.
    void tap(double x, double y) {
        turn(PointerEvent{PointerPhase::down, 0, x, y});
        turn(PointerEvent{PointerPhase::up, 0, x, y});
    }
    void tap(Part part, int index = 0) {
        const PxBox box = kiosk.desk().find(part, index)->box;
        tap(shifted_x(box.left + box.width / 2.0), shifted_y(box.top + box.height / 2.0));
    }
    /// Turn after turn until this much time has passed; fades take frames of 20 ms, as on a display.
    void pass(double seconds) {
        for (const double until = stage.now_s() + seconds; stage.now_s() < until;) {
            kiosk.turn(until - stage.now_s());
            if (kiosk.show().fading(stage.now_s()))
                stage.advance(std::min(0.02, until - stage.now_s()));
        }
        turn();
    }

    const VisitState& state() const { return kiosk.visit().state(); }
    PxSize picture() const {
        return turned({stage.surface_width_px(), stage.surface_height_px()}, stage.rotation_deg());
    }
    /// Where the desk's places are seen: shifted against burn-in.
    Shift shift;
    double shifted_x(double x) const { return x + shift.x_px; }
    double shifted_y(double y) const { return y + shift.y_px; }

    std::string text;
    int minute = 12 * 60, loads = 0;
    /// Called while an exhibit is loaded; in each turn, between its events and its drawing.
    std::function<void()> in_loading = [] {}, in_the_turn = [] {};
    /// What becomes of an exhibit that was loaded: for what no file can say.
    std::function<Exhibit(Exhibit)> edit = [](Exhibit exhibit) { return exhibit; };
    std::string described;
    std::vector<std::string> lines;
    SurfacelessStage stage;

    Log log{[this](std::string_view line) { lines.emplace_back(line); },
            [] { return std::chrono::steady_clock::time_point(); }, false};
    Kiosk kiosk;
};

/// The frame as people see it.
class Seen8 {
public:
    explicit Seen8(const TestKiosk& at)
        : surface_{at.stage.surface_width_px(), at.stage.surface_height_px()},
          rotation_deg_(at.stage.rotation_deg()),
          rgba_(at.stage.read_rgba()) {}

    EncodedRgb8 operator()(int x, int y) const {
        const PxPoint at = surface_from_picture({x + 0.5, y + 0.5}, surface_, rotation_deg_);
        const auto pixel = static_cast<std::size_t>(
            4 * (static_cast<int>(at.y_px) * surface_.width_px + static_cast<int>(at.x_px)));
        return {rgba_[pixel], rgba_[pixel + 1], rgba_[pixel + 2]};
    }

private:
    PxSize surface_;
    int rotation_deg_;
    std::vector<std::uint8_t> rgba_;
};

inline int apart(const EncodedRgb8& a, const EncodedRgb8& b) {
    return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

inline std::string text_of(const EncodedRgb8& c) {
    return std::to_string(c.r) + ' ' + std::to_string(c.g) + ' ' + std::to_string(c.b);
}

} // namespace metamer
