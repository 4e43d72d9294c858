// A scene on the stage: its two sides as pictures, drawn again only when something changed.
#pragma once

#include <array>
#include <functional>
#include <optional>

#include "gles/framebuffer.h"
#include "kiosk/compositor.h"
#include "render/frame_renderer.h"
#include "visit/visit_state.h"
#include "window/rotation.h"

namespace metamer {

/// Its GL objects come with the first draw.
class Play {
public:
    explicit Play(Exhibit exhibit);

    /// Changes the exhibit's lamps, strengths, materials, methods; not its objects' number or scene. What
    /// follows is planned and drawn with the next draw().
    void change(const std::function<void(Exhibit&)>& edit);

    /// Draws what is stale. `scene`: the box's size that the scene fills. Throws what FrameRenderer throws.
    /// Leaves another framebuffer bound.
    void draw(PxSize scene);

    /// Lays the scene on the box, right of `split` (0 .. 1) the right side; out of `before`, a picture of the
    /// same box bound to kBeforeUnit, where `share` < 1.
    void lay(Compositor& compositor, const PxBox& box, double split, const Patch& before, float share) const;

    /// Gives the pictures' memory back while another scene is shown; the next draw() draws anew.
    void rest();

    /// How long the last draw() took on the GPU and to submit, without planning, ms.
    double frame_ms() const { return frame_ms_; }
    const Exhibit& exhibit() const { return exhibit_; }
    /// Whether each side shows the whole scene in half of the width; else both fill it, and a split parts
    /// them.
    bool side_by_side() const { return halves_side_by_side(exhibit_); }
    /// After the first draw().
    const FrameRenderer& renderer() const { return *renderer_; }

private:
    PxSize side_size(PxSize scene) const;
    void draw_sides(int width, int height);
    Patch patch(double from, double to) const;

    Exhibit exhibit_;
    std::optional<FrameRenderer> renderer_;
    std::array<std::optional<Framebuffer>, 2> sides_;
    PxSize drawn_; ///< of one side; 0: nothing yet
    int scale_ = 1;
    double frame_ms_ = 0;
    bool changed_ = false;
};

} // namespace metamer
