// What a visitor has chosen: plain data. The start state is what an exhibit returns to.
#pragma once

#include <optional>
#include <string>

#include "exhibit/exhibit.h"

namespace metamer {

/// What the scene compares.
enum class Mode {
    methods, ///< one lamp, two ways of computing: [compare]
    booth,   ///< one way of computing, two lamps: a light booth with a metameric pair
};

/// What a touch on the scene meant: the object and, of its key map, the material.
struct Seen {
    std::size_t object = 0;
    std::string material; ///< its name: keys change when an exhibit is loaded anew
    bool operator==(const Seen&) const = default;
};

struct VisitState {
    Mode mode = Mode::methods;
    /// Of KioskSetting::lamps, the spectrum of every lamp; none: each lamp's own, as the INI says.
    std::optional<std::size_t> lamp;
    double strength = 1;      ///< factor on every lamp's and half's own, kLeastStrength .. kMostStrength
    double split = 0.5;       ///< 0 .. 1
    std::optional<Seen> seen; ///< whose panel is open
    std::string language = "en";
    bool expert = false;
    /// Mode booth: the lamps of both sides, of KioskSetting::lamps.
    std::size_t booth_left = 0, booth_right = 0;

    bool operator==(const VisitState&) const = default;
};

inline constexpr double kLeastStrength = 0.05, kMostStrength = 20;

/// As the exhibit starts.
VisitState start_state(const Exhibit& exhibit);

/// Where the right half begins, 0 .. 1; 0 where the exhibit compares nothing.
double split_share(const Exhibit& exhibit);

/// Whether each half shows all of the scene in half of the width, as a light booth does: there is no split.
bool halves_side_by_side(const Exhibit& exhibit);

/// How many lamps the shelf shows: none where each half has a lamp of its own, which it would not change. A
/// booth takes two.
std::size_t lamps_to_choose(const Exhibit& exhibit);

/// The slider's place 0 .. 1 of a strength and back; logarithmic, 1 in the middle.
double slider_of_strength(double strength);
double strength_of_slider(double slider);

/// The exhibit as it is to be drawn in this state, mode methods: lamps' spectra and strengths changed in
/// `drawn`, which started as a copy of `exhibit`. Only what FrameRenderer::update() takes over is touched.
void apply(const VisitState& state, const Exhibit& exhibit, Exhibit& drawn);

} // namespace metamer
