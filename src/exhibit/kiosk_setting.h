// [kiosk] and [tour.N]: what a visitor may choose, and what runs while nobody is there.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "exhibit/lamp_setting.h"

namespace metamer {

struct Exhibit;

inline constexpr int kMostShelfLamps = 12; ///< tiles that a screen has room for
inline constexpr int kMostTourSteps = 64;

/// [tour.N]: one step of the tour.
struct TourStep {
    std::optional<std::size_t> lamp; ///< of KioskSetting::lamps; none: as the step before
    std::optional<double> split;     ///< likewise
    /// The exhibit with the step's own materials, without tour; none: as the step before.
    std::shared_ptr<const Exhibit> scene;
    std::map<std::string, std::string> captions; ///< by language; "" for every other
    double seconds = 8;

    /// The caption in this language, else the one without a language, else "".
    std::string caption(const std::string& language) const;
};

/// Minutes after midnight, local time; `from` may lie after `to`: over midnight.
struct NightHours {
    int from_min = 0, to_min = 0;
};

/// [kiosk]
struct KioskSetting {
    double idle_s = 60;             ///< without a touch, until the tour runs
    std::string language = "en";    ///< that the exhibit starts with
    std::string language_place;     ///< where that is written: `kiosk.ini:12`; empty: nowhere
    std::filesystem::path strings;  ///< the folder of the languages; empty: the program's own
    std::vector<LampSetting> lamps; ///< the shelf; only lamp and key count
    /// Of `lamps`, what the booth starts with: two, unless the shelf has one or somebody wrote the same
    /// twice.
    std::size_t booth_left = 0, booth_right = 0;
    std::vector<TourStep> tour;
    std::optional<NightHours> night;
    int pixel_shift_px = 4; ///< against burn-in; 0: none
    double watch_s = 60;    ///< how often the picture watchdog looks; 0: never
    bool fullscreen = true; ///< [display] fullscreen
    int rotation_deg = 0;   ///< [display] rotation, clockwise
    double diagonal_in = 0; ///< [display] diagonal, of the screen; 0: as the display says
};

} // namespace metamer
