#include "kiosk/play.h"

#include <GLES2/gl2.h>
#include <chrono>
#include <cmath>

#include "gles/texture.h"

namespace metamer {

namespace {

/// Of a side's picture, whose own sides are powers of two: 24 MiB with its depth, as much as old boards have
/// for it.
constexpr long kMostSupersampled = 1L << 22;

// Supersampled only where the GPU has room for it.
int scale_for(PxSize side, int asked) {
    const int width = side.width_px * asked, height = side.height_px * asked;
    const bool small = static_cast<long>(texture_side(width)) * texture_side(height) <= kMostSupersampled;
    return small && has_room_for_picture(width, height) ? asked : 1;
}

} // namespace

Play::Play(Exhibit exhibit) : exhibit_(std::move(exhibit)) {}

void Play::change(const std::function<void(Exhibit&)>& edit) {
    edit(exhibit_);
    changed_ = true;
}

PxSize Play::side_size(PxSize scene) const {
    return {side_by_side() ? (scene.width_px + 1) / 2 : scene.width_px, scene.height_px};
}

void Play::draw(PxSize scene) {
    const PxSize size = side_size(scene);
    if (drawn_ == size && !changed_)
        return;
    if (!renderer_)
        renderer_.emplace(exhibit_);
    else if (changed_)
        renderer_->update();
    changed_ = false;
    scale_ = scale_for(size, exhibit_.display.supersample);
    const auto began = std::chrono::steady_clock::now();
    draw_sides(size.width_px * scale_, size.height_px * scale_);
    glFinish();
    frame_ms_ = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - began).count();
    drawn_ = size;
}

void Play::draw_sides(int width, int height) {
    const std::size_t sides = renderer_->plan().halves.size();
    for (std::size_t i = 0; i < sides; ++i) {
        picture_with_room(sides_[i], width, height, DepthBuffer::depth16).bind();
        renderer_->draw_side(i, width, height);
    }
    if (sides == 1)
        sides_[1].reset();
}

// From share to share of a side's width.
Patch Play::patch(double from, double to) const {
    const auto texture_width = static_cast<float>(sides_[0]->width_px()),
               texture_height = static_cast<float>(sides_[0]->height_px());
    const auto width = static_cast<float>(drawn_.width_px * scale_) / texture_width,
               height = static_cast<float>(drawn_.height_px * scale_) / texture_height;
    return {width * static_cast<float>(from), 0, width * static_cast<float>(to - from), height};
}

void Play::lay(Compositor& compositor, const PxBox& box, double split, const Patch& before,
               float share) const {
    const int column = static_cast<int>(std::lround(split * box.width));
    const double at = static_cast<double>(column) / box.width;
    for (std::size_t i = 0; i < 2; ++i) {
        const PxBox part = i == 0 ? PxBox{box.left, box.top, column, box.height}
                                  : PxBox{box.left + column, box.top, box.width - column, box.height};
        if (part.width == 0)
            continue;
        const double from = i == 0 ? 0 : at, to = i == 0 ? at : 1;
        (sides_[i] ? sides_[i] : sides_[0])->bind_texture(kPictureUnit);
        const Patch shown =
            side_by_side() ? patch(0, static_cast<double>(part.width) / drawn_.width_px) : patch(from, to);
        if (share >= 1) {
            compositor.lay(part, shown);
            continue;
        }
        const Patch old{before.left + before.width * static_cast<float>(from), before.bottom,
                        before.width * static_cast<float>(to - from), before.height};
        compositor.fade(part, shown, old, share);
    }
}

void Play::rest() {
    sides_ = {};
    drawn_ = {};
}

} // namespace metamer
