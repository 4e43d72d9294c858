// Which object a touch hits.
#pragma once

#include <optional>

#include "render/scene.h"

namespace metamer {

struct Hit {
    std::size_t object;  ///< of Exhibit::objects
    double u = 0, v = 0; ///< texture coordinates there
};

/// The nearest front face under a point of the frame, by the ray through it (Moeller and Trumbore 1997).
/// `x`, `y`: 0 .. 1 from the frame's upper left corner; `aspect`: width / height. Of a scene that either half
/// shows all of (SceneKindInfo::each_half) the half is the frame. None where nothing is.
std::optional<Hit> pick(const Scene& scene, const Exhibit& exhibit, double x, double y, double aspect);

/// The key of the material there: the object's own, or what its key map says.
int material_key(const Exhibit& exhibit, const Hit& hit);

} // namespace metamer
