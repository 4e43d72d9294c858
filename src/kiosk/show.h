// Everything of the kiosk that lives on the GPU: scenes, words, and how they make a frame. Made anew after a
// lost context.
#pragma once

#include <array>
#include <optional>

#include "gles/texture.h"
#include "kiosk/compositor.h"
#include "kiosk/desk.h"
#include "kiosk/overlay_textures.h"
#include "kiosk/play.h"
#include "visit/visit.h"

namespace metamer {

/// Which scene, lit how: what a frame's scene depends on. The split is not among it: it moves without
/// drawing.
struct Cue {
    Mode mode = Mode::methods;
    const Exhibit* scene = nullptr; ///< the tour's; nullptr: the exhibit's own
    std::optional<std::size_t> lamp;
    double strength = 1;
    std::size_t booth_left = 0, booth_right = 0;
    bool operator==(const Cue&) const = default;
};
Cue cue_of(const Visit& visit);

class Show {
public:
    /// The exhibit must live as long.
    explicit Show(const Exhibit& exhibit);

    /// Draws the scene of this cue at this size, where the last one was another, and begins a cross-fade from
    /// the old picture where more than the strength changed. Throws bad_input where the planner refuses,
    /// failure where GL does; the last cue is to be staged again then.
    void stage(const Cue& cue, PxSize scene, double now_s);

    /// Composes a frame into the bound framebuffer: scene, split line, words. `dark`: nothing but black.
    void compose(const Desk& desk, PxSize picture, int rotation_deg, Shift shift, double split, double now_s,
                 bool dark);

    /// Paints what changed of the widgets.
    void paint(const Desk& desk);

    /// From the choice on: the fade's time begins with its first frame, whatever planning and drawing took.
    bool fading(double now_s) const { return fade_begins_ || now_s < fade_began_s_ + kFade_s; }

    const Play& play() const { return *current_; }
    /// How long the last scene took to draw, ms.
    double frame_ms() const { return current_->frame_ms(); }
    const OverlayTextures& overlay() const { return overlay_; }

private:
    Play& play_for(const Cue& cue);
    const Exhibit& booth_at_one(const Cue& cue);
    void light(Play& play, const Cue& cue);
    void keep_old_picture(PxSize scene, double now_s);
    void lay_scene(const PxBox& box, double split, double now_s);

    const Exhibit& exhibit_;
    Compositor compositor_;
    OverlayTextures overlay_;
    Texture ground_, line_; ///< behind the controls, over the split
    Play own_;
    std::optional<Play> booth_, tour_;
    std::optional<Exhibit> booth_at_one_; ///< at strength 1, for these lamps: its cards take time
    std::array<std::size_t, 2> booth_lamps_{};
    const Exhibit* toured_ = nullptr;
    Play* current_ = nullptr;
    std::optional<Cue> cue_;
    /// What the scene fades out of; and room for what it fades out of next, which in the middle of a fade is
    /// the mixture.
    std::optional<Framebuffer> before_, room_;
    Patch before_patch_;
    bool fade_begins_ = false;
    double fade_began_s_ = -1e9, last_split_ = 0.5;
};

} // namespace metamer
