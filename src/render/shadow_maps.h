// Shadow maps (Williams 1978) of up to four lamps, tiles of one texture; drawn once, as nothing in a scene
// moves.
#pragma once

#include <glm/mat4x4.hpp>
#include <optional>
#include <span>
#include <vector>

#include "gles/framebuffer.h"
#include "gles/mesh.h"
#include "render/scene.h"

namespace metamer {

/// Where a lamp's tile lies and how it looks at the scene.
struct ShadowTile {
    glm::mat4 shadow_from_world; ///< world to the lamp's clip space
    glm::vec4 depth_from_world;  ///< . (x, y, z, 1) is the depth along the lamp's axis: 0 near, 1 far, linear
    glm::vec2 corner;            ///< of the tile, s and t
};

/// The lamp's view of the sphere around the scene: parallel for directions, a cone for positions (at most 120
/// degrees), which looks down where the lamp stands in the very middle. `corner` stays (0, 0).
ShadowTile shadow_view(const glm::vec4& place, const glm::vec3& center, float radius);

/// The texture and its tiles. Move-only, needs a context; leaves the GL state of saved_state.h as it was.
class ShadowMaps {
public:
    /// Draws `meshes` for lamps at these places (position, w = 1; direction towards the lamp, w = 0), at most
    /// kMostShadows; none makes an empty object that binds nothing.
    ShadowMaps(std::span<const glm::vec4> places, const Scene& scene, std::span<const Mesh> meshes);

    void bind(int unit) const;
    std::span<const ShadowTile> tiles() const { return tiles_; }

private:
    std::optional<Framebuffer> map_;
    std::vector<ShadowTile> tiles_;
};

} // namespace metamer
