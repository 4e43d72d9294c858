// What the outside tells a kiosk, from its first moment on.
#pragma once

#include <atomic>
#include <mutex>

#include "service/signals.h"
#include "window/stage.h"

namespace metamer {

/// Where OutsideWatch tells, whether there is a stage already or one is still waited for.
class Outlet {
public:
    /// Goes to the stage as its event; from any thread. What comes before there is a stage is kept.
    void tell(Outside what);

    /// Tells this stage from now on, which must live as long as somebody tells; what was kept it is told now,
    /// as one change.
    void lead_to(Stage& stage);

    /// Whether an end was told, with a stage or without.
    bool quit() const { return quit_; }

private:
    std::atomic<bool> quit_{false};
    std::mutex mutex_; ///< guards what follows
    Stage* stage_ = nullptr;
    bool changed_ = false;
};

} // namespace metamer
