#include "kiosk/compositor.h"

#include <GLES2/gl2.h>

#include "render/meshes.h"
#include "render/programs.h"
#include "render/variants.h"

namespace metamer {

namespace {

MeshData unit_square() {
    MeshData square;
    add_quad(square, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
    return square;
}

glm::vec4 to_glm(const Patch& patch) {
    return {patch.left, patch.bottom, patch.width, patch.height};
}

} // namespace

Compositor::Compositor() : laid_(build_program(picture_variant(false))), square_(unit_square()) {}

void Compositor::begin(PxSize picture, int rotation_deg) {
    picture_ = picture;
    shift_ = {};
    turn_ = surface_clip_from_picture_clip(rotation_deg);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_DITHER);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
}

void Compositor::place(const Program& program, const PxBox& box, const Patch& patch) const {
    const auto width = static_cast<float>(picture_.width_px), height = static_cast<float>(picture_.height_px);
    const auto left = static_cast<float>(box.left + shift_.x_px),
               bottom = height - static_cast<float>(box.bottom() + shift_.y_px);
    program.use();
    program.set("u_place", glm::vec4(2 * left / width - 1, 2 * bottom / height - 1,
                                     2 * static_cast<float>(box.width) / width,
                                     2 * static_cast<float>(box.height) / height));
    program.set("u_turn", glm::vec4(turn_[0], turn_[1], turn_[2], turn_[3]));
    program.set("u_uv", to_glm(patch));
    program.set("u_picture", kPictureUnit);
}

void Compositor::lay(const PxBox& box, const Patch& patch, float share) {
    place(laid_, box, patch);
    laid_.set("u_share", share);
    square_.draw();
}

void Compositor::fade(const PxBox& box, const Patch& patch, const Patch& before, float share) {
    if (!fading_)
        fading_.emplace(build_program(picture_variant(true)));
    place(*fading_, box, patch);
    fading_->set("u_before", kBeforeUnit);
    fading_->set("u_before_uv", to_glm(before));
    fading_->set("u_share", share);
    square_.draw();
}

} // namespace metamer
