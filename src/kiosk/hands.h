// From touches and keys to wishes. Pure: what lies where is passed in.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <span>

#include "kiosk/desk.h"
#include "window/events.h"

namespace metamer {

/// What touches and keys act on.
struct Within {
    const Desk* desk;
    const VisitState* state;
    const Words* words;
    /// The object under a point of the picture, px; none where the scene is not, or empty there.
    std::function<std::optional<Seen>(double x_px, double y_px)> pick;
    std::span<const Seen> objects; ///< of the scene, for the keyboard
};

class Hands {
public:
    /// A finger: buttons act when it lifts where it came down; sliders and the split follow it; a tap on the
    /// scene opens the object there. Takes the keyboard's focus away.
    std::optional<Action> pointer(const PointerEvent& event, const Within& within);

    /// A key. Tab, down and up move the focus through all that can be touched, the scene among them; left and
    /// right move sliders, the split, and from object to object in the scene, elsewhere the focus; enter does
    /// what a tap does; escape closes what is open.
    std::optional<Action> key(const KeyEvent& event, const Within& within);

    const std::optional<Focus>& focus() const { return focus_; }

    /// Lets go of everything: the visitor is gone, the screen another.
    void let_go();

private:
    struct Grab {
        std::optional<Focus> widget; ///< none: the scene
        double x_px, y_px;           ///< where it came down
        double split_offset_px = 0;  ///< from the finger to the split
        bool on_split = false;
        bool dragged = false; ///< too far for a tap, whether it came back or not
    };
    static bool slipped(const Grab& grab, const PointerEvent& event, const Within& within);
    Grab grabbed(const PointerEvent& event, const Within& within) const;
    std::optional<Action> follow(const Grab& grab, const PointerEvent& event, const Within& within) const;
    std::optional<Action> lift(const Grab& grab, const PointerEvent& event, const Within& within) const;
    void move_focus(int by, const Within& within);
    std::optional<Action> nudge(int by, const Within& within);
    std::optional<Action> enter(const Within& within);

    std::map<int, Grab> fingers_;
    std::optional<Focus> focus_;
};

/// Half of the width about the split that takes hold of it, and how far a tap may slip: elsewhere, and there,
/// where what slips drags. In units (mm).
inline constexpr double kSplitReach = 4, kTapSlip = 6, kSplitSlip = 1.5;

} // namespace metamer
