// The scene of objects, figures 52-53: shapes on a table before a wall.
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>

#include "base/error.h"
#include "render/meshes.h"
#include "render/scene_kinds.h"

namespace metamer {

namespace {

using Profile = std::vector<glm::vec2>;

void add_table(MeshData& mesh) {
    add_quad(mesh, {-4, 0, 3}, {4, 0, 3}, {4, 0, -1.8f}, {-4, 0, -1.8f});
}

void add_wall(MeshData& mesh) {
    add_quad(mesh, {-4, -0.5f, -1.8f}, {4, -0.5f, -1.8f}, {4, 4, -1.8f}, {-4, 4, -1.8f});
}

void add_vase(MeshData& mesh) {
    const Profile profile{{0, 0},         {0, 0},         {0.24f, 0},     {0.24f, 0},     {0.36f, 0.25f},
                          {0.38f, 0.5f},  {0.26f, 0.85f}, {0.13f, 1.1f},  {0.14f, 1.25f}, {0.21f, 1.38f},
                          {0.21f, 1.38f}, {0.17f, 1.37f}, {0.17f, 1.37f}, {0.1f, 1.2f},   {0.1f, 1.0f}};
    add_lathe(mesh, {0.62f, 0, -0.45f}, profile);
}

void add_apple(MeshData& mesh) {
    const Profile profile{{0, 0.06f},    {0.1f, 0.01f}, {0.2f, 0.02f},  {0.3f, 0.14f}, {0.35f, 0.32f},
                          {0.32f, 0.5f}, {0.2f, 0.6f},  {0.09f, 0.59f}, {0, 0.52f}};
    add_lathe(mesh, {-0.1f, 0, 0.62f}, profile);
}

void add_cone(MeshData& mesh) {
    const Profile profile{{0, 0}, {0, 0}, {0.38f, 0}, {0.38f, 0}, {0, 0.95f}};
    add_lathe(mesh, {1.5f, 0, -0.25f}, profile);
}

void add_cloth(MeshData& mesh) {
    // A hand-towel laid over the table, rising in soft folds towards the wall.
    const auto point = [](double u, double v) {
        const double x = 0.95 + 0.95 * u, z = 1.5 - 0.75 * v;
        const double y = 0.015 + 0.05 * (1 + std::sin(9 * u + 2 * v)) * (0.25 + 0.75 * v);
        return glm::vec3(x, y, z);
    };
    add_surface(mesh, point, 24, 6);
}

// By the names that exhibit/scene_kinds lists.
const std::map<std::string, std::function<void(MeshData&)>, std::less<>>& shapes() {
    static const std::map<std::string, std::function<void(MeshData&)>, std::less<>> table{
        {"table", add_table},
        {"wall", add_wall},
        {"ball",
         [](MeshData& m) {
             add_sphere(m, {-1.35f, 0.55f, 0.05f}, 0.55);
         }},
        {"orange",
         [](MeshData& m) {
             add_sphere(m, {-0.78f, 0.3f, 1.05f}, 0.3);
         }},
        {"apple", add_apple},
        {"box",
         [](MeshData& m) {
             add_box(m, {-0.35f, 0.45f, -0.75f}, {0.8f, 0.9f, 0.6f}, 0.5);
         }},
        {"vase", add_vase},
        {"cone", add_cone},
        {"ring",
         [](MeshData& m) {
             add_torus(m, {0.55f, 0.11f, 0.95f}, 0.27, 0.11);
         }},
        {"cloth", add_cloth},
    };
    return table;
}

} // namespace

Scene build_still_life(const Exhibit& exhibit) {
    Scene scene;
    for (const ObjectSetting& setting : exhibit.objects) {
        const auto shape = shapes().find(setting.name);
        if (shape == shapes().end())
            throw failure("build", "the still life", "there is no shape for object " + setting.name);
        SceneObject object{&setting, {}};
        shape->second(object.mesh);
        scene.objects.push_back(std::move(object));
    }
    scene.camera = {.eye = {0.1f, 2.2f, 6},
                    .target = {0, 0.52f, 0},
                    .field_of_view_deg = 26,
                    .half_size = {2.25f, 1.28f}};
    scene.center = {0, 0.6f, 0};
    scene.radius = 2.4f;
    for (const glm::vec3& direction :
         {glm::vec3(-0.5f, 1, 0.8f), glm::vec3(0.9f, 0.8f, 0.5f), glm::vec3(0, 0.6f, 1),
          glm::vec3(-1, 0.5f, 0), glm::vec3(1, 0.5f, 0), glm::vec3(0, 1, 0.1f), glm::vec3(-0.4f, 0.3f, 1),
          glm::vec3(0.4f, 0.3f, 1)})
        scene.lamp_directions.push_back(glm::normalize(direction));
    return scene;
}

} // namespace metamer
