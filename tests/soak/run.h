// A kiosk that lives through months in minutes: touched, reloaded, robbed of its context and its files.
#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "kiosk/kiosk.h"
#include "service/log.h"
#include "service/signals.h"
#include "soak/visitor.h"
#include "soak/vitals.h"
#include "soak/world.h"
#include "window/surfaceless_stage.h"

namespace metamer::test {

struct Plight {
    long frames = 2000;
    int mutations = 100, losses = 10, checks = 10;
    std::uint32_t seed = 20155;
};

/// Scripted by `seed`: the same on every run, but for what inotify notices.
class Run {
public:
    explicit Run(const Plight& plight);

    /// All of it. Throws std::runtime_error where the kiosk does not come back to the same picture, or shows
    /// a widget outside the screen; and what the kiosk throws.
    void live();

    /// At each check, after the kiosk came back to the start of its tour.
    const std::vector<Vitals>& checks() const { return checks_; }
    /// Lines of the log, by event kind.
    const std::map<std::string, long>& events() const { return events_; }
    double simulated_s() const { return stage_.now_s(); }
    long noticed_changes() const { return noticed_; }

private:
    KioskParts parts();
    std::unique_ptr<Loaded> load();
    int minute_of_day() const;
    void next();
    void trouble();
    void check();
    void back_to_the_tour();
    void look_at(const std::string& description) const;

    Plight plight_;
    World world_;
    std::mt19937 rng_;
    Visitor visitor_;
    SurfacelessStage stage_;
    std::map<std::string, long> events_;
    double log_s_ = 0;
    Log log_;
    std::atomic<long> noticed_{0};
    OutsideWatch outside_;
    bool quiet_ = false; ///< nobody touches anything
    int mutations_ = 0, losses_ = 0;
    long hours_ = 0;
    std::vector<Vitals> checks_;
    std::vector<std::uint8_t> picture_; ///< at the first check
    std::optional<Kiosk> kiosk_;
};

} // namespace metamer::test
