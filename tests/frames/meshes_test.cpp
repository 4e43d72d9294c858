#include "render/meshes.h"

#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace metamer {
namespace {

struct Vertex {
    glm::vec3 position, normal, tangent;
};

Vertex vertex(const MeshData& mesh, std::size_t i) {
    const float* v = &mesh.vertices[i * kVertexFloats];
    return {{v[0], v[1], v[2]}, {v[3], v[4], v[5]}, {v[6], v[7], v[8]}};
}

/// Triangles turn the way that their normals point, tangents lie in the surface, and all is of unit length.
void expect_sound(const MeshData& mesh) {
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const Vertex a = vertex(mesh, mesh.indices[i]), b = vertex(mesh, mesh.indices[i + 1]),
                     c = vertex(mesh, mesh.indices[i + 2]);
        const glm::vec3 side = glm::cross(b.position - a.position, c.position - a.position);
        if (glm::length(side) > 1e-6f) {
            ASSERT_GT(glm::dot(side, a.normal + b.normal + c.normal), 0) << i;
        }
        ASSERT_NEAR(glm::length(a.normal), 1, 1e-4);
        ASSERT_NEAR(glm::length(a.tangent), 1, 1e-4);
        ASSERT_NEAR(glm::dot(a.normal, a.tangent), 0, 2e-2);
    }
}

TEST(Meshes, SphereHasItsRadiusAndLooksOutwards) {
    MeshData mesh;
    add_sphere(mesh, {1, 2, 3}, 0.5);
    expect_sound(mesh);
    for (std::size_t i = 0; i < mesh.vertices.size() / kVertexFloats; ++i) {
        const Vertex v = vertex(mesh, i);
        const glm::vec3 out = v.position - glm::vec3(1, 2, 3);
        EXPECT_NEAR(glm::length(out), 0.5, 1e-5);
        EXPECT_GT(glm::dot(out, v.normal), 0.49f);
    }
}

TEST(Meshes, BoxTorusAndLatheAreSound) {
    MeshData box, torus, cone;
    add_box(box, {0, 0, 0}, {1, 2, 3}, 0.4);
    expect_sound(box);
    add_torus(torus, {0, 0, 0}, 1, 0.3);
    expect_sound(torus);
    const std::vector<glm::vec2> profile{{0, 0}, {0, 0}, {0.4f, 0}, {0.4f, 0}, {0, 1}};
    add_lathe(cone, {0, 0, 0}, profile);
    expect_sound(cone);
    lay_along_x(cone);
    expect_sound(cone);
}

TEST(Meshes, LatheGoesThroughItsProfile) {
    MeshData mesh;
    const std::vector<glm::vec2> profile{{0.2f, 0}, {0.5f, 0.5f}, {0.3f, 1}};
    add_lathe(mesh, {0, 0, 0}, profile);
    float widest = 0;
    for (std::size_t i = 0; i < mesh.vertices.size() / kVertexFloats; ++i) {
        const glm::vec3 p = vertex(mesh, i).position;
        const float r = std::hypot(p.x, p.z);
        if (std::abs(p.y - 0.5f) < 1e-5f) {
            EXPECT_NEAR(r, 0.5, 1e-5);
        }
        widest = std::max(widest, r);
    }
    EXPECT_LT(widest, 0.53f);
}

} // namespace
} // namespace metamer
