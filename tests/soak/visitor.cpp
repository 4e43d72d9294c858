#include "soak/visitor.h"

#include <vector>

namespace metamer::test {

void Visitor::tap(double x, double y, int finger) {
    coming_.emplace_back(PointerEvent{PointerPhase::down, finger, x, y});
    coming_.emplace_back(PointerEvent{PointerPhase::up, finger, x, y});
}

void Visitor::drag(double x, double y, double to_x, double to_y, int steps) {
    coming_.emplace_back(PointerEvent{PointerPhase::down, 0, x, y});
    for (int i = 1; i <= steps; ++i) {
        const double along = static_cast<double>(i) / steps;
        coming_.emplace_back(
            PointerEvent{PointerPhase::move, 0, x + along * (to_x - x), y + along * (to_y - y)});
    }
    coming_.emplace_back(PointerEvent{PointerPhase::up, 0, to_x, to_y});
}

void Visitor::on_widget(const Desk& desk) {
    std::vector<const Widget*> touchable;
    for (const Widget& widget : desk.widgets)
        if (widget.touchable)
            touchable.push_back(&widget);
    if (touchable.empty())
        return;
    const Widget& widget =
        *touchable[static_cast<std::size_t>(up_to(static_cast<int>(touchable.size()) - 1))];
    const double y = widget.box.top + widget.box.height / 2.0;
    if (widget.part == Part::strength)
        drag(widget.box.left + share() * widget.box.width, y, widget.box.left + share() * widget.box.width, y,
             6);
    else
        tap(widget.box.left + widget.box.width / 2.0, y);
}

void Visitor::in_the_scene(const Desk& desk, PxSize picture) {
    if (const Widget* handle = desk.find(Part::split); handle != nullptr && up_to(3) > 0)
        drag(handle->box.left + handle->box.width / 2.0, handle->box.top + handle->box.height / 2.0,
             share() * picture.width_px, share() * picture.height_px, 40);
    else
        tap(desk.layout.scene.left + share() * desk.layout.scene.width,
            desk.layout.scene.top + share() * desk.layout.scene.height);
}

void Visitor::by_keys() {
    for (int i = up_to(6); i >= 0; --i)
        coming_.emplace_back(KeyEvent{static_cast<Key>(up_to(static_cast<int>(Key::back_tab)))});
}

// In any order, lost and cancelled ones among them, also outside of the picture.
void Visitor::with_all_fingers(PxSize picture) {
    for (int i = up_to(20); i >= 0; --i)
        coming_.emplace_back(PointerEvent{static_cast<PointerPhase>(up_to(3)), up_to(3),
                                          (1.2 * share() - 0.1) * picture.width_px,
                                          (1.2 * share() - 0.1) * picture.height_px});
}

std::optional<Event> Visitor::next(const Desk& desk, PxSize picture) {
    if (coming_.empty()) {
        const int what = up_to(9);
        if (what < 3)
            on_widget(desk);
        else if (what < 7)
            in_the_scene(desk, picture);
        else if (what == 7)
            by_keys();
        else if (what == 8)
            with_all_fingers(picture);
        // Looks at what came of it; sometimes goes away.
        coming_.resize(coming_.size() + static_cast<std::size_t>(up_to(40) == 0 ? 400 : up_to(12)));
    }
    if (coming_.empty())
        return std::nullopt;
    const std::optional<Event> event = coming_.front();
    coming_.pop_front();
    return event;
}

} // namespace metamer::test
