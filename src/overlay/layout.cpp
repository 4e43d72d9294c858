#include "overlay/layout.h"

#include <algorithm>
#include <cmath>

#include "overlay/controls.h"

namespace metamer {

namespace {

// Units.
constexpr double kWidestLabel = 90, kWidestNotice = 110, kWidestHint = 100, kWidestCaption = 140;
constexpr double kWidestPanel = 170, kHighestPanel = 78, kHighestExpert = 64;
constexpr double kHandleWidth = 12;
// Below this width (units), or where the scene is not so much wider than high, the expert's panel stands over
// the other things, not beside them.
constexpr double kNarrowScene = 118, kWideAspect = 1.1;
constexpr double kPad = 2.4; ///< in the slider, at the ends of its track

/// A part of the scene still free, units.
struct Free {
    double left, top, right, bottom;
    double width() const { return right - left; }
    double height() const { return bottom - top; }
};

/// Where the scene is drawn, units; its left edge is the screen's.
struct Scene {
    double top, right, bottom;
};

class OverScene {
public:
    OverScene(const Controls& controls, const Contents& contents, const Scene& scene, Layout& layout)
        : unit_px_(controls.unit_px),
          gap_(controls.gap),
          contents_(contents),
          layout_(layout),
          free_{gap_, scene.top + gap_, scene.right - gap_, scene.bottom} {}

    void place() {
        if (contents_.notice)
            layout_.notice = from_top(notice_height(), kWidestNotice);
        if (!contents_.panel)
            free_.bottom -= kHandleHeight + kCloseInset + gap_;
        Free below = free_;
        if (contents_.expert)
            place_expert(below);
        if (contents_.panel) {
            place_panel(below);
            return;
        }
        if (contents_.hint)
            layout_.hint = from_bottom(below, kHintHeight, kWidestHint);
        if (contents_.caption)
            layout_.caption = from_bottom(below, kCaptionHeight, kWidestCaption);
    }

private:
    PxBox box(double left, double top, double right, double bottom) const {
        return px_box(unit_px_, left, top, right, bottom);
    }

    /// Panels are for visitors: where they need the room, two lines have to do.
    double notice_height() const {
        constexpr double kTwoLines = 7, kPanels = 80;
        const bool panels = contents_.panel || contents_.expert;
        return panels ? std::clamp(free_.height() - kPanels, kTwoLines, kNoticeHeight) : kNoticeHeight;
    }

    PxBox from_top(double height, double widest) {
        const double top = free_.top;
        free_.top += height + gap_;
        return box(free_.right - std::min(widest, free_.width()), top, free_.right, top + height);
    }

    PxBox from_bottom(Free& free, double height, double widest) const {
        const double bottom = free.bottom, width = std::min(widest, free.width());
        const double left = free.left + (free.width() - width) / 2;
        free.bottom -= height + gap_;
        return box(left, bottom - height, left + width, bottom);
    }

    /// Beside what follows, or above it; leaves that in `below`.
    void place_expert(Free& below) {
        if (free_.width() >= std::max(kNarrowScene, kWideAspect * free_.height())) {
            const double width = std::clamp(0.36 * free_.width(), 46.0, 84.0);
            const double left = free_.right - width;
            const double bottom = std::min(free_.bottom, free_.top + kHighestExpert);
            layout_.expert_panel = box(left, free_.top, free_.right, bottom);
            below.right = left - gap_;
            return;
        }
        const double lines =
            (contents_.hint ? kHintHeight + gap_ : 0) + (contents_.caption ? kCaptionHeight + gap_ : 0);
        const double height = contents_.panel ? 0.45 * free_.height() : free_.height() - lines;
        const double bottom = free_.top + std::min(height, kHighestExpert);
        layout_.expert_panel = box(free_.left, free_.top, free_.right, bottom);
        below.top = bottom + gap_;
    }

    void place_panel(Free below) {
        const double height = std::min(below.height(), kHighestPanel);
        below.top = below.bottom - height;
        layout_.panel = from_bottom(below, height, kWidestPanel);
        const double right = layout_.panel.right() / unit_px_ - kCloseInset;
        const double bottom = layout_.panel.bottom() / unit_px_ - kCloseInset;
        layout_.close = box(right - kCloseWidth, bottom - kCloseHeight, right, bottom);
        const double next = right - kCloseWidth - kCloseInset;
        layout_.next = box(next - kNextWidth, bottom - kCloseHeight, next, bottom);
    }

    double unit_px_, gap_;
    const Contents& contents_;
    Layout& layout_;
    Free free_;
};

/// Above the scene, so that they hide nothing of it.
void place_labels(const Controls& controls, double width, Layout& layout) {
    const double gap = controls.gap, label = std::min((width - 3 * gap) / 2, kWidestLabel);
    const double bottom = gap + kLabelHeight;
    layout.left_label = px_box(controls.unit_px, gap, gap, gap + label, bottom);
    layout.right_label = px_box(controls.unit_px, width - gap - label, gap, width - gap, bottom);
}

void mirror(const ScreenSize& screen, const Contents& contents, Layout& layout) {
    const auto turn = [&](PxBox& box, int width_px) {
        if (box.width > 0)
            box.left = width_px - box.right();
    };
    for (PxBox* box : {&layout.strength, &layout.mode, &layout.expert, &layout.panel, &layout.next,
                       &layout.close, &layout.expert_panel, &layout.caption, &layout.hint, &layout.notice})
        turn(*box, screen.width_px);
    for (PxBox& box : layout.languages)
        turn(box, screen.width_px);
    // Each shelf in its own half: turned over the whole screen they would change places.
    if (contents.booth)
        std::swap(layout.lamps, layout.lamps_right);
    for (auto* shelf : {&layout.lamps, &layout.lamps_right})
        for (PxBox& box : *shelf)
            turn(box, screen.width_px);
}

} // namespace

Layout lay_out(const ScreenSize& screen, const Contents& contents) {
    const Controls controls = arrange_controls(screen, contents);
    Layout layout;
    layout.unit_px = controls.unit_px;
    place_controls(controls, screen, contents, layout);
    const double width = screen.width_px / controls.unit_px;
    place_labels(controls, width, layout);
    const Scene scene{kLabelHeight + 2 * controls.gap, width,
                      screen.height_px / controls.unit_px - controls.height};
    layout.scene = px_box(controls.unit_px, 0, scene.top, scene.right, scene.bottom);
    OverScene(controls, contents, scene, layout).place();
    if (contents.right_to_left)
        mirror(screen, contents, layout);
    return layout;
}

PxBox split_handle(const Layout& layout, double split) {
    if (layout.panel.width > 0)
        return {};
    const auto px = [&](double units) { return static_cast<int>(std::lround(units * layout.unit_px)); };
    const int width = px(kHandleWidth), height = px(kHandleHeight);
    const PxBox& scene = layout.scene;
    const double middle = scene.left + std::clamp(split, 0.0, 1.0) * scene.width;
    const int left = std::clamp(static_cast<int>(std::lround(middle - width / 2.0)), scene.left,
                                std::max(scene.right() - width, scene.left));
    return {left, scene.bottom() - px(kCloseInset) - height, width, height};
}

PxBox slider_track(const PxBox& slider, double unit_px) {
    const int pad = std::min(static_cast<int>(std::lround(kPad * unit_px)), slider.width / 4);
    const int top = slider.top + slider.height * 6 / 10;
    return {slider.left + pad, top, slider.width - 2 * pad, slider.bottom() - top};
}

double slider_value(const PxBox& slider, double unit_px, bool right_to_left, double x_px) {
    const PxBox track = slider_track(slider, unit_px);
    const double share = std::clamp((x_px - track.left) / std::max(track.width, 1), 0.0, 1.0);
    return right_to_left ? 1 - share : share;
}

} // namespace metamer
