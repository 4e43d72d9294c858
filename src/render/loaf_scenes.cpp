// Scenes that show a list of materials one beside the other, each of them across the whole split: the loaf's
// slices lie on each other, the crayons lie side by side.
#include <algorithm>
#include <glm/geometric.hpp>
#include <numbers>

#include "render/meshes.h"
#include "render/scene_kinds.h"

namespace metamer {

namespace {

// From the viewer's side, so that both halves of the split get the same light; further lamps to the sides.
std::vector<glm::vec3> lamps_at_the_viewer() {
    std::vector<glm::vec3> out;
    for (const glm::vec3& direction :
         {glm::vec3(0, 0.45, 1), glm::vec3(-1, 0.4, 0.6), glm::vec3(1, 0.4, 0.6), glm::vec3(0, 1, 0.2),
          glm::vec3(0, -0.4, 1), glm::vec3(-0.6, 0, 1), glm::vec3(0.6, 0, 1), glm::vec3(0, 0, 1)})
        out.push_back(glm::normalize(direction));
    return out;
}

} // namespace

// The wall stands behind the floor; u runs from their common edge outwards, either is 1 deep and twice as
// wide.
Scene build_corner(const Exhibit& exhibit) {
    Scene scene;
    for (const ObjectSetting& setting : exhibit.objects) {
        SceneObject plane{&setting, {}};
        if (setting.name == "wall")
            add_quad(plane.mesh, {1, 0, 0}, {1, 1, 0}, {-1, 1, 0}, {-1, 0, 0});
        else
            add_quad(plane.mesh, {-1, 0, 0}, {-1, 0, 1}, {1, 0, 1}, {1, 0, 0});
        scene.objects.push_back(std::move(plane));
    }
    scene.camera = {
        .eye = {0, 2.6f, 5}, .target = {0, 0.36f, 0.4f}, .field_of_view_deg = 22, .half_size = {1.2f, 0.85f}};
    scene.radius = 1.6f;
    // The first grazes the floor, which lives on the wall's light; the second the wall.
    for (const glm::vec3& direction :
         {glm::vec3(0, 0.2f, 1), glm::vec3(0, 1, 0.2f), glm::vec3(-0.5f, 0.6f, 0.7f),
          glm::vec3(0.5f, 0.6f, 0.7f), glm::vec3(-0.8f, 0.3f, 0.5f), glm::vec3(0.8f, 0.3f, 0.5f),
          glm::vec3(0, 1, 0), glm::vec3(0, 1, 1)})
        scene.lamp_directions.push_back(glm::normalize(direction));
    return scene;
}

Scene build_loaf(const Exhibit& exhibit) {
    Scene scene;
    const auto n = static_cast<float>(exhibit.objects.size());
    const float pitch = 2 / n, slice = pitch * 0.94f;
    for (std::size_t i = 0; i < exhibit.objects.size(); ++i) {
        SceneObject object{&exhibit.objects[i], {}};
        const float y = 1 - (static_cast<float>(i) + 0.5f) * pitch;
        // Edge on: the cube's edge stands in the middle, its two faces are lit alike.
        add_box(object.mesh, {0, y, 0}, {2, slice, 2}, std::numbers::pi / 4);
        scene.objects.push_back(std::move(object));
    }
    scene.camera = {
        .eye = {0, 1.6f, 6}, .target = {0, -0.17f, 0}, .field_of_view_deg = 24, .half_size = {1.75f, 1.72f}};
    scene.radius = 1.8f;
    scene.lamp_directions = lamps_at_the_viewer();
    return scene;
}

Scene build_crayons(const Exhibit& exhibit) {
    Scene scene;
    const auto n = static_cast<float>(exhibit.objects.size());
    const float pitch = 2 / n,
                r = std::min(0.47f * pitch,
                             0.14f); // few crayons are no thicker, or their tips leave the frame
    // Wrapper, wax, tip; lying along x the bottom is at the left.
    const float shoulder = 1.45f, tip = shoulder + 2.6f * r;
    const std::vector<glm::vec2> profile{{0, -1.7f},
                                         {0, -1.7f},
                                         {r, -1.7f},
                                         {r, -1.7f},
                                         {r, 1.35f},
                                         {r, 1.35f},
                                         {0.84f * r, 1.35f},
                                         {0.84f * r, 1.35f},
                                         {0.84f * r, shoulder},
                                         {0.84f * r, shoulder},
                                         {0.3f * r, tip},
                                         {0.3f * r, tip},
                                         {0, tip + 0.1f * r}};
    for (std::size_t i = 0; i < exhibit.objects.size(); ++i) {
        SceneObject object{&exhibit.objects[i], {}};
        add_lathe(object.mesh, {0, 0, 0}, profile);
        lay_along_x(object.mesh);
        const float y = 1 - (static_cast<float>(i) + 0.5f) * pitch;
        for (std::size_t v = 0; v < object.mesh.vertices.size(); v += kVertexFloats)
            object.mesh.vertices[v + 1] += y;
        scene.objects.push_back(std::move(object));
    }
    scene.camera = {
        .eye = {0, 0, 8}, .target = {0, 0, 0}, .field_of_view_deg = 18, .half_size = {1.85f, 1.06f}};
    scene.radius = 2.2f;
    scene.lamp_directions = lamps_at_the_viewer();
    return scene;
}

} // namespace metamer
