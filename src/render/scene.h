// A scene: an exhibit's objects as shapes in world space, the eye, and where lamps stand that the INI does
// not place.
#pragma once

#include <glm/mat4x4.hpp>
#include <vector>

#include "exhibit/exhibit.h"
#include "gles/mesh_data.h"

namespace metamer {

/// A shape with the setting of its name.
struct SceneObject {
    const ObjectSetting* setting; ///< of the exhibit, which must live longer
    MeshData mesh;
};

/// The eye. `target` stays in the middle; the box `half_size` about it stays in view at any aspect.
struct Camera {
    glm::vec3 eye{0, 0, 1}, target{0};
    double field_of_view_deg = 30; ///< vertical; narrow frames are seen from further back
    glm::vec2 half_size{1};
    bool flat = false; ///< vertices are in clip space already: ramps and patches fill the frame
};

struct Scene {
    std::vector<SceneObject> objects;
    Camera camera;
    bool lit = true;     ///< false: I_shading = 1 everywhere
    glm::vec3 center{0}; ///< of a sphere around everything that casts shadows
    float radius = 1;
    std::vector<glm::vec3>
        lamp_directions; ///< towards lamp 1, 2, ... where the INI says nothing; kMostLamps of them
};

/// The column where the right half begins, 0 .. width_px.
int split_column(const Compare& compare, int width_px);

/// Builds the scene of the exhibit's kind.
Scene build_scene(const Exhibit& exhibit);

/// World to clip for a frame of this aspect (width / height), and the eye's place (moved back so that all
/// stays in view).
struct View {
    glm::mat4 clip_from_world{1};
    glm::vec3 eye{0, 0, 1};
};
View view_of(const Camera& camera, double aspect);

} // namespace metamer
