// What the CPU says that an unlit scene's objects look like in each half.
#pragma once

#include "kiosk/kiosks.h"
#include "plan/twin.h"

namespace metamer {

/// The exhibit of a text with a state's lamp and strength.
inline Exhibit lit(const std::string& text, const VisitState& state) {
    const Exhibit base = kiosk_exhibit(text);
    Exhibit drawn = base;
    apply(state, base, drawn);
    return drawn;
}

/// Points of a box a few pixels apart, and what stands there of an unlit scene: those near the split, borders
/// of objects and under widgets are left out.
struct Place {
    int x, y; ///< of the picture, without any shift
    std::size_t object, half;
};
inline std::vector<Place> places(const TestKiosk& at) {
    constexpr int kClear = 3;
    const Desk& desk = at.kiosk.desk();
    const PxBox& scene = desk.layout.scene;
    const Play& play = at.kiosk.show().play();
    const int step = std::max(7, scene.width / 48);
    const int column = scene.left + static_cast<int>(std::lround(at.state().split * scene.width));
    const auto object = [&](int x, int y) {
        const auto hit =
            pick(play.renderer().scene(), play.exhibit(), (x + 0.5 - scene.left) / scene.width,
                 (y + 0.5 - scene.top) / scene.height, static_cast<double>(scene.width) / scene.height);
        return hit ? static_cast<int>(hit->object) : -1;
    };
    const auto hidden = [&](int x, int y) {
        return std::any_of(desk.widgets.begin(), desk.widgets.end(), [&](const Widget& widget) {
            return x >= widget.box.left - kClear && x < widget.box.right() + kClear &&
                   y >= widget.box.top - kClear && y < widget.box.bottom() + kClear;
        });
    };
    std::vector<Place> all;
    for (int y = scene.top + kClear; y < scene.bottom() - kClear; y += step)
        for (int x = scene.left + kClear; x < scene.right() - kClear; x += step) {
            const int here = object(x, y);
            const bool alone = object(x - kClear, y) == here && object(x + kClear, y) == here &&
                               object(x, y - kClear) == here && object(x, y + kClear) == here;
            if (here >= 0 && alone && !hidden(x, y) && std::abs(x - column) > kClear + 2)
                all.push_back({x, y, static_cast<std::size_t>(here), x < column ? 0u : 1u});
        }
    return all;
}

inline constexpr int kMostSteps = 2; ///< the GPU's float against the CPU's, and a linear filter between

/// Whether the scene looks as the exhibit does, wherever it can be seen.
inline void expect_colors(const TestKiosk& at, const Exhibit& drawn) {
    const Twin twin(drawn);
    const Seen8 seen(at);
    std::size_t looked = 0;
    for (const Place& place : places(at)) {
        const EncodedRgb8 expected = twin.color(place.object, place.half);
        const EncodedRgb8 shown = seen(place.x + at.shift.x_px, place.y + at.shift.y_px);
        ASSERT_LE(apart(shown, expected), kMostSteps)
            << "object " << place.object << " in half " << place.half << " at " << place.x << ", " << place.y
            << ": " << text_of(shown) << " where " << text_of(expected) << " belongs";
        ++looked;
    }
    EXPECT_GT(looked, 0u);
}

} // namespace metamer
