#include "kiosk/outlet.h"

namespace metamer {

namespace {

Event event_of(Outside what) {
    switch (what) {
    case Outside::quit:
        return QuitEvent{};
    case Outside::reload:
        return ReloadEvent{};
    default:
        return FilesChangedEvent{};
    }
}

} // namespace

void Outlet::tell(Outside what) {
    if (what == Outside::quit)
        quit_ = true;
    const std::lock_guard lock(mutex_);
    if (stage_ != nullptr)
        stage_->post(event_of(what));
    else if (what != Outside::quit)
        changed_ = true;
}

void Outlet::lead_to(Stage& stage) {
    const std::lock_guard lock(mutex_);
    stage_ = &stage;
    if (changed_)
        stage.post(FilesChangedEvent{});
    changed_ = false;
}

} // namespace metamer
