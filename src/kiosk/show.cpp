#include "kiosk/show.h"

#include <GLES2/gl2.h>
#include <array>
#include <cmath>
#include <utility>

#include "exhibit/booth.h"
#include "overlay/theme.h"
#include "visit/visit_state.h"

namespace metamer {

namespace {

/// The line over the split.
constexpr Srgb kLine{0xD9, 0xD9, 0xD9};

Texture of_one_color(const Srgb& color) {
    return {1, 1, std::array<std::uint8_t, 4>{color[0], color[1], color[2], 255}};
}

VisitState state_of(const Cue& cue) {
    VisitState state;
    state.lamp = cue.lamp;
    state.strength = cue.strength;
    return state;
}

// Objects keep their places in memory: scenes point to their settings.
void take_over(const Exhibit& fresh, Exhibit& drawn) {
    for (std::size_t i = 0; i < drawn.objects.size(); ++i)
        drawn.objects[i].material = fresh.objects[i].material;
    drawn.lamps = fresh.lamps;
    drawn.compare = fresh.compare;
    drawn.atlas = fresh.atlas;
    drawn.materials = fresh.materials;
}

bool only_brightness(Cue a, const Cue& b) {
    a.strength = b.strength;
    return a == b;
}

} // namespace

Cue cue_of(const Visit& visit) {
    const VisitState& state = visit.state();
    return {state.mode, visit.scene(), state.lamp, state.strength, state.booth_left, state.booth_right};
}

Show::Show(const Exhibit& exhibit)
    : exhibit_(exhibit), ground_(of_one_color(kBackdrop)), line_(of_one_color(kLine)), own_(exhibit) {}

Play& Show::play_for(const Cue& cue) {
    if (cue.mode == Mode::booth) {
        if (!booth_)
            booth_.emplace(booth_at_one(cue));
        return *booth_;
    }
    if (!cue.scene)
        return own_;
    if (toured_ != cue.scene) {
        tour_.emplace(*cue.scene);
        toured_ = cue.scene;
    }
    return *tour_;
}

const Exhibit& Show::booth_at_one(const Cue& cue) {
    const std::array lamps{cue.booth_left, cue.booth_right};
    if (!booth_at_one_ || booth_lamps_ != lamps) {
        const std::vector<LampSetting>& shelf = exhibit_.kiosk.lamps;
        booth_at_one_ = booth_exhibit(exhibit_, shelf[cue.booth_left], shelf[cue.booth_right]);
        booth_lamps_ = lamps;
    }
    return *booth_at_one_;
}

void Show::light(Play& play, const Cue& cue) {
    play.change([&](Exhibit& drawn) {
        if (cue.mode == Mode::methods) {
            apply(state_of(cue), cue.scene ? *cue.scene : exhibit_, drawn);
            return;
        }
        take_over(booth_at_one(cue), drawn);
        for (LampSetting& lamp : drawn.lamps)
            lamp.strength *= cue.strength;
    });
}

void Show::keep_old_picture(PxSize scene, double now_s) {
    const Framebuffer& room = picture_with_room(room_, scene.width_px, scene.height_px, DepthBuffer::none);
    room.bind();
    glViewport(0, 0, scene.width_px, scene.height_px);
    compositor_.begin(scene, 0);
    lay_scene({0, 0, scene.width_px, scene.height_px}, last_split_, now_s);
    std::swap(before_, room_);
    before_patch_ = {0, 0, static_cast<float>(scene.width_px) / static_cast<float>(before_->width_px()),
                     static_cast<float>(scene.height_px) / static_cast<float>(before_->height_px())};
}

void Show::lay_scene(const PxBox& box, double split, double now_s) {
    const double share = fade_begins_ ? 0 : fade(now_s - fade_began_s_);
    if (before_)
        before_->bind_texture(kBeforeUnit);
    current_->lay(compositor_, box, current_->side_by_side() ? 0.5 : split, before_patch_,
                  before_ ? static_cast<float>(share) : 1);
}

void Show::stage(const Cue& cue, PxSize scene, double now_s) {
    const bool another = !cue_ || !(*cue_ == cue);
    const bool fades = another && cue_ && !only_brightness(*cue_, cue);
    if (fades)
        keep_old_picture(scene, now_s);
    Play* const before = current_;
    try {
        Play& play = play_for(cue);
        if (another)
            light(play, cue);
        play.draw(scene);
        current_ = &play;
    } catch (...) {
        // Back to what worked: the caller stages it again.
        if (cue_) {
            current_ = &play_for(*cue_);
            light(*current_, *cue_);
        }
        throw;
    }
    if (before && before != current_)
        before->rest();
    fade_begins_ = fade_begins_ || fades;
    cue_ = cue;
}

void Show::paint(const Desk& desk) {
    overlay_.update(desk.widgets, desk.layout.unit_px);
}

void Show::compose(const Desk& desk, PxSize picture, int rotation_deg, Shift shift, double split,
                   double now_s, bool dark) {
    if (std::exchange(fade_begins_, false))
        fade_began_s_ = now_s;
    compositor_.begin(picture, rotation_deg);
    if (dark)
        return;
    ground_.bind(kPictureUnit);
    compositor_.lay({0, 0, picture.width_px, picture.height_px}, {});
    compositor_.shift(shift);
    const PxBox& scene = desk.layout.scene;
    lay_scene(scene, split, now_s);
    last_split_ = split;
    const double at = current_->side_by_side() ? 0.5 : split;
    if (current_->renderer().plan().halves.size() > 1 && at > 0 && at < 1) {
        const int column = scene.left + static_cast<int>(std::lround(at * scene.width));
        const int width = std::max(2, static_cast<int>(std::lround(desk.layout.unit_px / 3)));
        line_.bind(kPictureUnit);
        compositor_.lay({column - width / 2, scene.top, width, scene.height}, {});
    }
    overlay_.lay(compositor_, desk.widgets);
}

} // namespace metamer
