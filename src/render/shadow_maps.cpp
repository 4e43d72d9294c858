#include "render/shadow_maps.h"

#include <GLES2/gl2.h>
#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "gles/program.h"
#include "render/programs.h"
#include "render/variants.h"

namespace metamer {

namespace {

// Two depths closer than this share of the tile's range are one surface: a texel's slope and 16 bits of
// depth.
constexpr float kDepthBias = 0.004f;

} // namespace

glm::mat4 shadow_view(const glm::vec4& place, const glm::vec3& center, float radius) {
    const glm::vec3 at(place);
    const bool directional = place.w == 0;
    const glm::vec3 towards_lamp = directional ? at : glm::normalize(at - center);
    // lookAt fails for an upright view along its up vector.
    const glm::vec3 up = std::abs(towards_lamp.y) > 0.99f ? glm::vec3(0, 0, 1) : glm::vec3(0, 1, 0);
    if (directional) {
        const glm::mat4 view = glm::lookAt(center + 2 * radius * at, center, up);
        return glm::ortho(-radius, radius, -radius, radius, radius, 3 * radius) * view;
    }
    const float distance = std::max(glm::length(at - center), 0.1f);
    const float half_angle = std::min(std::asin(std::min(radius / distance, 0.866f)), glm::radians(60.0f));
    const float near = std::max(distance - radius, 0.1f);
    return glm::perspective(2 * half_angle, 1.0f, near, distance + radius) * glm::lookAt(at, center, up);
}

ShadowMaps::ShadowMaps(std::span<const HalfLamp> lamps, const Scene& scene, std::span<const Mesh> meshes) {
    for (const HalfLamp& lamp : lamps) {
        if (!lamp.shadow)
            break;
        const auto i = tiles_.size();
        const glm::vec3 tile{0.5f * static_cast<float>(i % 2), 0.5f * static_cast<float>(i / 2), kDepthBias};
        tiles_.push_back({shadow_view(lamp.place, scene.center, scene.radius), tile});
    }
    if (tiles_.empty())
        return;
    map_.emplace(2 * kShadowTilePx, 2 * kShadowTilePx, DepthBuffer::depth16, ColorBuffer::texture);
    map_->bind();
    glClearColor(1, 1, 1, 1); // as far as can be: nothing stands in the light
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    const Program program = build_program(shadow_variant());
    for (const ShadowTile& tile : tiles_) {
        glViewport(static_cast<GLint>(tile.tile.x * 2 * kShadowTilePx),
                   static_cast<GLint>(tile.tile.y * 2 * kShadowTilePx), kShadowTilePx, kShadowTilePx);
        program.set("u_shadow_from_world", tile.shadow_from_world);
        for (const Mesh& mesh : meshes)
            mesh.draw();
    }
}

void ShadowMaps::bind(int unit) const {
    if (map_)
        map_->bind_texture(unit);
}

} // namespace metamer
