#include "soak/run.h"

#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "base/printed.h"
#include "exhibit/load.h"

namespace metamer::test {

namespace {

constexpr PxSize kScreen{400, 240};
constexpr double kFrame_s = 1.0 / 60, kLook_s = 15, kDay_s = 86400;

/// `reload_refused` of `event=reload_refused error=...`.
std::string kind_of(std::string_view line) {
    const std::size_t at = line.find("event=") + 6;
    return std::string(line.substr(at, line.find_first_of(" \n", at) - at));
}

} // namespace

Run::Run(const Plight& plight)
    : plight_(plight),
      rng_(plight.seed),
      visitor_(plight.seed + 1),
      stage_(kScreen.width_px, kScreen.height_px, 0, 2),
      // Every line counts: its clock goes on by more than the log's minute.
      log_([this](std::string_view line) { ++events_[kind_of(line)]; },
           [this] {
               log_s_ += 61;
               return std::chrono::steady_clock::time_point(std::chrono::seconds(static_cast<long>(log_s_)));
           },
           false),
      // Told, but not acted on: when it comes is the machine's affair.
      outside_([this](Outside) { ++noticed_; }) {
    stage_.on_idle([this] { next(); });
    kiosk_.emplace(parts());
}

KioskParts Run::parts() {
    KioskParts parts;
    parts.stage = &stage_;
    parts.log = &log_;
    parts.load = [this] { return load(); };
    parts.minute_of_day = [this] { return minute_of_day(); };
    parts.describe = [this](const std::string& text) { look_at(text); };
    return parts;
}

std::unique_ptr<Loaded> Run::load() {
    outside_.watch(exhibit_files(world_.exhibit()));
    std::vector<std::string> doubts;
    Exhibit exhibit = load_exhibit(world_.exhibit(), {}, &doubts, Use::kiosk);
    Words words = words_of(exhibit);
    return std::make_unique<Loaded>(Loaded{std::move(exhibit), std::move(words)});
}

int Run::minute_of_day() const {
    return static_cast<int>(std::fmod(stage_.now_s(), kDay_s) / 60);
}

void Run::look_at(const std::string& description) const {
    const auto screen = nlohmann::json::parse(description);
    for (const auto& widget : screen.at("widgets")) {
        const std::array<int, 4> box = widget.at("box");
        if (box[0] < 0 || box[1] < 0 || box[2] <= 0 || box[3] <= 0 ||
            box[0] + box[2] > screen.at("width_px").get<int>() ||
            box[1] + box[3] > screen.at("height_px").get<int>())
            throw std::runtime_error("outside of the screen: " + description);
    }
}

/// What happens while nothing is to be told: time passes, somebody does something.
void Run::next() {
    stage_.advance(kFrame_s);
    if (quiet_)
        return;
    trouble();
    const PxSize picture{stage_.surface_width_px(), stage_.surface_height_px()};
    if (const auto event = visitor_.next(kiosk_->desk(), picture))
        stage_.post(*event);
}

void Run::trouble() {
    const auto due = [&](int done, int all) {
        return done < all && stage_.frames_shown() * all >= plight_.frames * done;
    };
    if (due(mutations_, plight_.mutations)) {
        // Now and then all is well again, mostly one mishap follows the other.
        ++mutations_ % 8 == 0 ? world_.restore(static_cast<std::size_t>(mutations_ / 8))
                              : world_.befall(rng_);
        stage_.post(FilesChangedEvent{});
    }
    if (due(losses_, plight_.losses)) {
        ++losses_;
        stage_.lose_context();
    }
    if (const auto hours = static_cast<long>(stage_.now_s() / 3600); hours > hours_) {
        hours_ = hours;
        stage_.post(ReloadEvent{});
        if (hours % 5 == 0)
            stage_.resize(hours % 10 == 0 ? 320 : kScreen.width_px, kScreen.height_px);
        if (hours % 7 == 0) {
            stage_.post(DisplayGoneEvent{});
            stage_.post(DisplayBackEvent{});
        }
    }
}

/// All files whole, nobody there, noon: the start of the tour, and the cross-fade to it is over.
void Run::back_to_the_tour() {
    constexpr int kMostTurns = 1000;
    quiet_ = true;
    visitor_.leave();
    world_.restore(0);
    stage_.resize(kScreen.width_px, kScreen.height_px);
    // The pixel shift's round goes evenly into a day: it stands where it stood.
    const double noon = (std::floor(stage_.now_s() / kDay_s) + 1.5) * kDay_s;
    stage_.advance(noon - stage_.now_s());
    stage_.post(FilesChangedEvent{});
    kiosk_->turn(0);
    stage_.post(ReloadEvent{});
    kiosk_->turn(0);
    for (int i = 0; kiosk_->visit().step() != 0 || kiosk_->show().fading(stage_.now_s()); ++i) {
        if (i == kMostTurns)
            throw std::runtime_error("the tour does not begin");
        kiosk_->turn(kFrame_s);
    }
    kiosk_->turn(0);
    quiet_ = false;
    hours_ = static_cast<long>(stage_.now_s() / 3600);
}

void Run::check() {
    back_to_the_tour();
    std::vector<std::uint8_t> picture = stage_.read_rgba();
    if (picture_.empty())
        picture_ = std::move(picture);
    else if (picture != picture_)
        throw std::runtime_error("another picture than at the first check");
    checks_.push_back(vitals());
    std::cout << printed("%7ld frames: ", stage_.frames_shown()) << text_of(checks_.back()) << std::endl;
}

void Run::live() {
    for (long checked = 0; stage_.frames_shown() < plight_.frames;) {
        kiosk_->turn(kLook_s);
        if (stage_.frames_shown() * plight_.checks >= plight_.frames * (checked + 1)) {
            ++checked;
            check();
        }
    }
}

} // namespace metamer::test
