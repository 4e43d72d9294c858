#include "render/scene.h"

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "render/scene_kinds.h"

namespace metamer {

int split_column(const Compare& compare, int width_px) {
    const int column =
        compare.split_px ? *compare.split_px : static_cast<int>(std::lround(compare.split * width_px));
    return std::clamp(column, 0, width_px);
}

Scene build_scene(const Exhibit& exhibit) {
    switch (exhibit.scene) {
    case SceneKind::loaf:
        return build_loaf(exhibit);
    case SceneKind::crayons:
        return build_crayons(exhibit);
    case SceneKind::still_life:
        return build_still_life(exhibit);
    case SceneKind::ramp:
        return build_ramp(exhibit);
    case SceneKind::media:
        return build_media(exhibit);
    case SceneKind::corner:
        return build_corner(exhibit);
    case SceneKind::booth:
        return build_booth(exhibit);
    case SceneKind::patches:
        break;
    }
    return build_patches(exhibit);
}

View view_of(const Camera& camera, double aspect) {
    if (camera.flat)
        return {};
    const double tangent = std::tan(glm::radians(camera.field_of_view_deg) / 2);
    const glm::dvec2 half_size(camera.half_size);
    const double distance = std::max(half_size.y / tangent, half_size.x / (tangent * aspect));
    const glm::vec3 back = glm::normalize(camera.eye - camera.target);
    const glm::vec3 eye = camera.target + static_cast<float>(distance) * back;
    const auto near = static_cast<float>(distance * 0.2), far = static_cast<float>(distance * 4);
    const auto fov = static_cast<float>(glm::radians(camera.field_of_view_deg));
    return {glm::perspective(fov, static_cast<float>(aspect), near, far) *
                glm::lookAt(eye, camera.target, glm::vec3(0, 1, 0)),
            eye};
}

} // namespace metamer
