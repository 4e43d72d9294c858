#include "render/shadow_maps.h"

#include <GLES2/gl2.h>
#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "gles/program.h"
#include "gles/saved_state.h"
#include "render/programs.h"
#include "render/variants.h"

namespace metamer {

namespace {

// 0 at `near`, 1 at `far` along the axis that leaves `at`.
glm::vec4 linear_depth(const glm::vec3& at, const glm::vec3& axis, float near, float far) {
    return glm::vec4(axis, -glm::dot(axis, at) - near) / (far - near);
}

} // namespace

ShadowTile shadow_view(const glm::vec4& place, const glm::vec3& center, float radius) {
    const glm::vec3 offset = glm::vec3(place) - center;
    const float distance = std::max(glm::length(offset), 0.1f);
    const glm::vec3 towards_lamp = place.w == 0                  ? glm::vec3(place)
                                   : glm::length(offset) < 1e-3f ? glm::vec3(0, 1, 0)
                                                                 : glm::normalize(offset);
    // lookAt fails for an upright view along its up vector.
    const glm::vec3 up = std::abs(towards_lamp.y) > 0.99f ? glm::vec3(0, 0, 1) : glm::vec3(0, 1, 0);
    if (place.w == 0) {
        const glm::vec3 at = center + 2 * radius * towards_lamp;
        return {glm::ortho(-radius, radius, -radius, radius, radius, 3 * radius) *
                    glm::lookAt(at, center, up),
                linear_depth(at, -towards_lamp, radius, 3 * radius),
                {}};
    }
    const glm::vec3 at(place);
    const float half_angle = std::min(std::asin(std::min(radius / distance, 0.866f)), glm::radians(60.0f));
    const float near = std::max(distance - radius, 0.1f), far = distance + radius;
    return {glm::perspective(2 * half_angle, 1.0f, near, far) * glm::lookAt(at, at - towards_lamp, up),
            linear_depth(at, -towards_lamp, near, far),
            {}};
}

ShadowMaps::ShadowMaps(std::span<const glm::vec4> places, const Scene& scene, std::span<const Mesh> meshes) {
    for (const glm::vec4& place : places) {
        const auto i = tiles_.size();
        tiles_.push_back(shadow_view(place, scene.center, scene.radius));
        tiles_.back().corner = {0.5f * static_cast<float>(i % 2), 0.5f * static_cast<float>(i / 2)};
    }
    if (tiles_.empty())
        return;
    const SavedState saved;
    const Program program = build_program(shadow_variant());
    map_.emplace(2 * kShadowTilePx, 2 * kShadowTilePx, DepthBuffer::depth16, ColorBuffer::texture);
    map_->bind();
    glDisable(GL_SCISSOR_TEST);
    glEnable(GL_DEPTH_TEST);
    glClearColor(1, 1, 1, 1); // as far as can be: nothing stands in the light
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    for (const ShadowTile& tile : tiles_) {
        glViewport(static_cast<GLint>(tile.corner.x * 2 * kShadowTilePx),
                   static_cast<GLint>(tile.corner.y * 2 * kShadowTilePx), kShadowTilePx, kShadowTilePx);
        program.set("u_shadow_from_world", tile.shadow_from_world);
        program.set("u_depth_from_world", tile.depth_from_world);
        for (const Mesh& mesh : meshes)
            mesh.draw();
    }
}

void ShadowMaps::bind(int unit) const {
    if (map_)
        map_->bind_texture(unit);
}

} // namespace metamer
