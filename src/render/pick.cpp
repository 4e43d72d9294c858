#include "render/pick.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace metamer {

namespace {

struct Ray {
    glm::dvec3 from, along; ///< `along` of length 1
};

// From the near plane on: what lies before it is not drawn. Clip space, where flat scenes are, grows away
// from the eye: mirrored in z it is a space like the world, with its fronts to the eye.
Ray ray_through(const Camera& camera, const View& view, double x, double y) {
    if (camera.flat)
        return {{2 * x - 1, 1 - 2 * y, 1}, {0, 0, -1}};
    const glm::dmat4 world_from_clip = glm::inverse(glm::dmat4(view.clip_from_world));
    const auto at = [&](double depth) {
        const glm::dvec4 p = world_from_clip * glm::dvec4(2 * x - 1, 1 - 2 * y, depth, 1);
        return glm::dvec3(p) / p.w;
    };
    const glm::dvec3 near = at(-1);
    return {near, glm::normalize(at(1) - near)};
}

struct Vertex {
    glm::dvec3 place;
    glm::dvec2 uv;
};

Vertex vertex(const MeshData& mesh, std::size_t index, bool mirrored) {
    const float* v = &mesh.vertices[index * static_cast<std::size_t>(kVertexFloats)];
    return {{v[0], v[1], mirrored ? -v[2] : v[2]}, {v[kUvAt], v[kUvAt + 1]}};
}

struct Crossing {
    double way;
    glm::dvec2 uv;
};

// Backs are culled, as where they are drawn.
std::optional<Crossing> crossing(const Ray& ray, const Vertex& a, const Vertex& b, const Vertex& c) {
    const glm::dvec3 ab = b.place - a.place, ac = c.place - a.place;
    const glm::dvec3 p = glm::cross(ray.along, ac);
    const double volume = glm::dot(ab, p); // above 0: seen from before
    if (!(volume > 0))
        return std::nullopt;
    const glm::dvec3 from_a = ray.from - a.place, q = glm::cross(from_a, ab);
    const double s = glm::dot(from_a, p) / volume, t = glm::dot(ray.along, q) / volume;
    const double way = glm::dot(ac, q) / volume;
    if (s < 0 || t < 0 || s + t > 1 || way < 0)
        return std::nullopt;
    return Crossing{way, a.uv + s * (b.uv - a.uv) + t * (c.uv - a.uv)};
}

std::size_t place_in(const Exhibit& exhibit, const ObjectSetting* setting) {
    return static_cast<std::size_t>(setting - exhibit.objects.data());
}

// A texel of a map whose rows begin at the top, repeated beyond its sides.
int texel(double share, int size) {
    return std::min(static_cast<int>((share - std::floor(share)) * size), size - 1);
}

} // namespace

std::optional<Hit> pick(const Scene& scene, const Exhibit& exhibit, double x, double y, double aspect) {
    const bool flat = scene.camera.flat;
    const Ray ray = ray_through(scene.camera, view_of(scene.camera, aspect), x, y);
    std::optional<Hit> nearest;
    double least = 0;
    for (const SceneObject& object : scene.objects) {
        const auto& indices = object.mesh.indices;
        const auto corner = [&](std::size_t i) { return vertex(object.mesh, indices[i], flat); };
        for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
            const auto at = crossing(ray, corner(i), corner(i + 1), corner(i + 2));
            if (!at || (nearest && at->way >= least))
                continue;
            least = at->way;
            nearest = {place_in(exhibit, object.setting), at->uv.x, at->uv.y};
        }
    }
    return nearest;
}

int material_key(const Exhibit& exhibit, const Hit& hit) {
    const ObjectSetting& object = exhibit.objects.at(hit.object);
    if (!object.key_map)
        return object.material.key;
    const Image& map = *object.key_map;
    const int column = texel(hit.u, map.width), row = map.height - 1 - texel(hit.v, map.height);
    return map.rgba[static_cast<std::size_t>(4 * (row * map.width + column))];
}

} // namespace metamer
