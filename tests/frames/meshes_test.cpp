#include "render/meshes.h"

#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <gtest/gtest.h>
#include <numbers>

namespace metamer {
namespace {

struct Vertex {
    glm::vec3 position, normal, tangent;
    glm::vec2 uv;
};

Vertex vertex(const MeshData& mesh, std::size_t i) {
    const float* v = &mesh.vertices[i * kVertexFloats];
    return {{v[0], v[1], v[2]}, {v[3], v[4], v[5]}, {v[6], v[7], v[8]}, {v[9], v[10]}};
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

TEST(Meshes, QuadCarriesTheMapUpright) {
    MeshData mesh;
    add_quad(mesh, {-1, 0, 5}, {3, 0, 5}, {3, 2, 5}, {-1, 2, 5});
    expect_sound(mesh);
    for (std::size_t i = 0; i < 4; ++i) {
        const Vertex v = vertex(mesh, i);
        EXPECT_EQ(v.normal, glm::vec3(0, 0, 1));
        EXPECT_EQ(v.tangent, glm::vec3(1, 0, 0)) << "along u";
        EXPECT_EQ(v.uv, glm::vec2((v.position.x + 1) / 4, v.position.y / 2));
    }
}

TEST(Meshes, TangentsRunAlongU) {
    MeshData mesh;
    add_surface(
        mesh, [](double u, double v) { return glm::vec3(2 * u, 3 * v, u * v); }, 4, 5);
    expect_sound(mesh);
    for (std::size_t i = 0; i < mesh.vertices.size() / kVertexFloats; ++i) {
        const Vertex v = vertex(mesh, i);
        EXPECT_EQ(v.tangent.y, 0);
        EXPECT_GT(v.tangent.x, 0.8f);
        EXPECT_NEAR(v.uv.x, v.position.x / 2, 1e-6);
        EXPECT_NEAR(v.uv.y, v.position.y / 3, 1e-6);
    }
}

TEST(Meshes, BoxTurnsAboutTheVertical) {
    MeshData mesh;
    add_box(mesh, {1, 2, 3}, {2, 4, 6}, 0.5);
    // The corner at (1, 2, 3) before the turn: the turn takes +z towards +x.
    const glm::vec3 turned(1 + std::cos(0.5) + 3 * std::sin(0.5), 4, 3 + 3 * std::cos(0.5) - std::sin(0.5));
    bool found = false;
    for (std::size_t i = 0; i < mesh.vertices.size() / kVertexFloats; ++i)
        found |= glm::distance(vertex(mesh, i).position, turned) < 1e-5f;
    EXPECT_TRUE(found);
}

TEST(Meshes, TorusHasItsTube) {
    MeshData mesh;
    add_torus(mesh, {0, 1, 0}, 2, 0.5);
    for (std::size_t i = 0; i < mesh.vertices.size() / kVertexFloats; ++i) {
        const glm::vec3 p = vertex(mesh, i).position;
        EXPECT_NEAR(std::hypot(std::hypot(p.x, p.z) - 2, p.y - 1), 0.5, 1e-5);
    }
}

// Half a pixel of the still life at 1280 x 720, around and along; both add on a diagonal. Coarse enough to be
// cheap, fine enough to be round.
TEST(Meshes, ChordsStayByTheirCurve) {
    for (const double radius : {0.08, 0.3, 0.55}) {
        MeshData mesh;
        add_sphere(mesh, {0, 0, 0}, radius);
        double furthest = 0;
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            const glm::vec3 middle =
                0.5f * (vertex(mesh, mesh.indices[i]).position + vertex(mesh, mesh.indices[i + 1]).position);
            furthest = std::max(furthest, radius - static_cast<double>(glm::length(middle)));
        }
        EXPECT_LE(furthest, 2 * 0.0017) << radius;
        EXPECT_GT(furthest, 0.0017) << radius << ": more triangles than a frame can show";
    }
    MeshData mesh;
    add_lathe(mesh, {0, 0, 0}, std::vector<glm::vec2>{{0.4f, 0}, {0.4f, 1}});
    for (std::size_t i = 0; i < mesh.vertices.size() / kVertexFloats; ++i) {
        const float y = vertex(mesh, i).position.y;
        EXPECT_TRUE(y == 0 || y == 1) << "a straight profile needs no ring between its ends";
    }
}

TEST(Meshes, OfPlanesWhereNoTriangleBends) {
    MeshData box, sphere, cylinder;
    add_box(box, {0, 0, 0}, {1, 2, 3}, 0.4);
    EXPECT_TRUE(is_of_planes(box));
    add_sphere(sphere, {0, 0, 0}, 1);
    EXPECT_FALSE(is_of_planes(sphere));
    add_lathe(cylinder, {0, 0, 0}, std::vector<glm::vec2>{{0.4f, 0}, {0.4f, 1}});
    EXPECT_FALSE(is_of_planes(cylinder));
    add_sphere(box, {0, 0, 0}, 1);
    EXPECT_FALSE(is_of_planes(box)) << "one round part is enough";
}

// Through a point that is given once the profile runs smoothly, along the chord of its neighbors.
TEST(Meshes, LatheIsSmoothAtASinglePoint) {
    MeshData mesh;
    const std::vector<glm::vec2> profile{{0.2f, 0}, {0.5f, 0.5f}, {0.3f, 1}};
    add_lathe(mesh, {0, 0, 0}, profile);
    const glm::vec2 normal = glm::normalize(glm::vec2(1, -0.1f)); // of the chord (0.1, 1)
    int seen = 0;
    for (std::size_t i = 0; i < mesh.vertices.size() / kVertexFloats; ++i) {
        const Vertex v = vertex(mesh, i);
        if (std::abs(v.position.y - 0.5f) > 1e-5f)
            continue;
        ++seen;
        EXPECT_NEAR(v.normal.y, normal.y, 0.02);
        const glm::vec2 out = glm::normalize(glm::vec2(v.position.x, v.position.z));
        EXPECT_NEAR(glm::dot(out, glm::vec2(v.normal.x, v.normal.z)), normal.x, 0.02) << "outwards";
    }
    EXPECT_GE(seen, 2 * (std::numbers::pi / std::acos(1 - 0.0017 / 0.5)))
        << "the end of one piece and the beginning of the next";
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
