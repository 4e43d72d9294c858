// From a pixel of a frame to the place in the world that it shows.
#pragma once

#include <array>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "render/scene.h"

namespace metamer {

/// Where the ray through the middle of a pixel meets the plane through `on` with this normal.
inline glm::dvec3 on_plane(const Exhibit& exhibit, const Scene& scene, int x, int y, const glm::dvec3& on,
                           const glm::dvec3& normal) {
    const double w = exhibit.display.width_px, h = exhibit.display.height_px;
    const View view = view_of(scene.camera, w / h);
    const glm::dmat4 world_from_clip = glm::inverse(glm::dmat4(view.clip_from_world));
    const glm::dvec4 far = world_from_clip * glm::dvec4(2 * (x + 0.5) / w - 1, 1 - 2 * (y + 0.5) / h, 1, 1);
    const glm::dvec3 eye(view.eye), direction = glm::dvec3(far) / far.w - eye;
    return eye + direction * (glm::dot(on - eye, normal) / glm::dot(direction, normal));
}

inline std::array<double, 3> array_of(const glm::dvec3& v) {
    return {v.x, v.y, v.z};
}

} // namespace metamer
