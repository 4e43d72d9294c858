// What stands on the screen at a moment: from the visit's state to widgets. Pure: nothing is drawn here.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "overlay/layout.h"
#include "overlay/widget.h"
#include "overlay/words.h"
#include "plan/exhibit_spectra.h"
#include "plan/planner.h"
#include "visit/visit.h"

namespace metamer {

/// Where the keyboard's focus is: a widget, or the scene.
struct Focus {
    Part part = Part::hint; ///< hint stands for the scene
    int index = 0;
    bool operator==(const Focus&) const = default;
};

/// The keyboard is on the scene: seen at the hint, or at the panel of what was chosen there.
inline constexpr Focus kSceneFocus{Part::hint, 0};

/// Everything that the screen tells of. Pointers are not owned.
struct Facts {
    const Exhibit* shelf;   ///< whose [kiosk] holds
    const Exhibit* exhibit; ///< whose scene is drawn
    const Plan* plan;
    const ExhibitSpectra* spectra;
    const Visit* visit;
    const Words* words;
    ScreenSize screen;
    std::optional<Focus> focus;
    std::string notice;
    double frame_ms = 0; ///< of the last drawn frame
};

struct Desk {
    Layout layout;
    std::vector<Widget> widgets; ///< in the order in which they are laid

    /// The topmost touchable widget at a point; nullptr where there is none.
    const Widget* at(double x_px, double y_px) const;
    const Widget* find(Part part, int index = 0) const;
};

/// What there is to lay out besides what lies over the scene: known before the plan is, which the desk tells
/// of, and enough for the scene's box.
Contents controls(const Exhibit& shelf, const Words& words, const VisitState& state);

/// Lays out and fills in. Not for the night, when nothing stands there.
Desk make_desk(const Facts& facts);

/// What the expert panel says, row by row.
ExpertPanel expert_panel(const Facts& facts);

} // namespace metamer
