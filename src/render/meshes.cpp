#include "render/meshes.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "base/error.h"

namespace metamer {

namespace {

constexpr double kTurn = 2 * std::numbers::pi;

// How far a chord may leave the curve that it stands for, scene units: half a pixel of the still life in a
// frame of 1280 x 720. Every triangle more costs time.
constexpr double kChordError = 0.0017;

// Chords of a whole circle; even, so that half of them make a meridian.
int chords_around(double radius) {
    const double turn = 2 * std::acos(1 - std::min(kChordError / radius, 1.0));
    return 2 * std::max(static_cast<int>(std::ceil(kTurn / turn / 2)), 4);
}

void add_vertex(MeshData& mesh, const glm::vec3& p, const glm::vec3& n, const glm::vec3& t, float u,
                float v) {
    mesh.vertices.insert(mesh.vertices.end(), {p.x, p.y, p.z, n.x, n.y, n.z, t.x, t.y, t.z, u, v});
}

std::size_t vertex_count(const MeshData& mesh) {
    return mesh.vertices.size() / kVertexFloats;
}

void add_triangle(MeshData& mesh, std::size_t a, std::size_t b, std::size_t c) {
    if (std::max({a, b, c}) > 65535)
        throw failure("build", "a mesh", "it has more than 65536 vertices");
    for (std::size_t i : {a, b, c})
        mesh.indices.push_back(static_cast<std::uint16_t>(i));
}

// Catmull-Rom between profile points i and i + 1; a doubled point ends the curve there.
glm::vec2 along(std::span<const glm::vec2> p, std::size_t i, float t) {
    const glm::vec2 a = p[i], b = p[i + 1];
    const bool starts = i == 0 || p[i - 1] == a, ends = i + 2 >= p.size() || p[i + 2] == b;
    const glm::vec2 in = starts ? b - a : 0.5f * (b - p[i - 1]), out = ends ? b - a : 0.5f * (p[i + 2] - a);
    const float t2 = t * t, t3 = t2 * t;
    return (2 * t3 - 3 * t2 + 1) * a + (t3 - 2 * t2 + t) * in + (3 * t2 - 2 * t3) * b + (t3 - t2) * out;
}

} // namespace

void add_surface(MeshData& mesh, const SurfaceFunction& point, int columns, int rows) {
    constexpr double step = 1e-3;
    const std::size_t first = vertex_count(mesh);
    for (int j = 0; j <= rows; ++j)
        for (int i = 0; i <= columns; ++i) {
            const double u = static_cast<double>(i) / columns, v = static_cast<double>(j) / rows;
            // Differences are taken a little inside, where poles and seams still have a direction.
            const double ui = std::clamp(u, 2 * step, 1 - 2 * step),
                         vi = std::clamp(v, 2 * step, 1 - 2 * step);
            const glm::vec3 du = point(ui + step, vi) - point(ui - step, vi);
            const glm::vec3 dv = point(ui, vi + step) - point(ui, vi - step);
            add_vertex(mesh, point(u, v), glm::normalize(glm::cross(du, dv)), glm::normalize(du),
                       static_cast<float>(u), static_cast<float>(v));
        }
    const auto width = static_cast<std::size_t>(columns) + 1;
    for (std::size_t j = 0; j < static_cast<std::size_t>(rows); ++j)
        for (std::size_t i = 0; i < static_cast<std::size_t>(columns); ++i) {
            const std::size_t a = first + j * width + i;
            add_triangle(mesh, a, a + 1, a + width + 1);
            add_triangle(mesh, a, a + width + 1, a + width);
        }
}

void add_quad(MeshData& mesh, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c,
              const glm::vec3& d) {
    const glm::vec3 tangent = glm::normalize(b - a), normal = glm::normalize(glm::cross(b - a, d - a));
    const std::size_t first = vertex_count(mesh);
    add_vertex(mesh, a, normal, tangent, 0, 0);
    add_vertex(mesh, b, normal, tangent, 1, 0);
    add_vertex(mesh, c, normal, tangent, 1, 1);
    add_vertex(mesh, d, normal, tangent, 0, 1);
    add_triangle(mesh, first, first + 1, first + 2);
    add_triangle(mesh, first, first + 2, first + 3);
}

void add_box(MeshData& mesh, const glm::vec3& center, const glm::vec3& size, double turn_rad) {
    const auto c = static_cast<float>(std::cos(turn_rad)), s = static_cast<float>(std::sin(turn_rad));
    const auto corner = [&](float x, float y, float z) {
        const glm::vec3 p = 0.5f * glm::vec3(x, y, z) * size;
        return center + glm::vec3(c * p.x + s * p.z, p.y, c * p.z - s * p.x);
    };
    add_quad(mesh, corner(-1, -1, 1), corner(1, -1, 1), corner(1, 1, 1), corner(-1, 1, 1));
    add_quad(mesh, corner(1, -1, -1), corner(-1, -1, -1), corner(-1, 1, -1), corner(1, 1, -1));
    add_quad(mesh, corner(1, -1, 1), corner(1, -1, -1), corner(1, 1, -1), corner(1, 1, 1));
    add_quad(mesh, corner(-1, -1, -1), corner(-1, -1, 1), corner(-1, 1, 1), corner(-1, 1, -1));
    add_quad(mesh, corner(-1, 1, 1), corner(1, 1, 1), corner(1, 1, -1), corner(-1, 1, -1));
    add_quad(mesh, corner(-1, -1, -1), corner(1, -1, -1), corner(1, -1, 1), corner(-1, -1, 1));
}

void add_lathe(MeshData& mesh, const glm::vec3& foot, std::span<const glm::vec2> profile) {
    float widest = 0;
    for (const glm::vec2& p : profile)
        widest = std::max(widest, p.x);
    for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
        if (profile[i] == profile[i + 1])
            continue;
        const auto ring = [&](double u, double v) {
            const glm::vec2 p = along(profile, i, static_cast<float>(v));
            const double angle = -kTurn * u; // so that dp/du x dp/dv points outwards
            return foot + glm::vec3(static_cast<double>(p.x) * std::cos(angle), p.y,
                                    static_cast<double>(p.x) * std::sin(angle));
        };
        // A chord's error falls with the square of their number.
        const double error = glm::length(along(profile, i, 0.5f) - 0.5f * (profile[i] + profile[i + 1]));
        const int rows = std::max(static_cast<int>(std::ceil(std::sqrt(error / kChordError))), 1);
        add_surface(mesh, ring, chords_around(widest), rows);
    }
}

void add_sphere(MeshData& mesh, const glm::vec3& center, double radius) {
    const auto point = [&](double u, double v) {
        const double around = -kTurn * u, up = std::numbers::pi * (v - 0.5);
        return center + glm::vec3(radius * std::cos(up) * std::cos(around), radius * std::sin(up),
                                  radius * std::cos(up) * std::sin(around));
    };
    add_surface(mesh, point, chords_around(radius), chords_around(radius) / 2);
}

void add_torus(MeshData& mesh, const glm::vec3& center, double radius, double tube) {
    const auto point = [&](double u, double v) {
        const double around = -kTurn * u, section = kTurn * v, r = radius + tube * std::cos(section);
        return center + glm::vec3(r * std::cos(around), tube * std::sin(section), r * std::sin(around));
    };
    add_surface(mesh, point, chords_around(radius + tube), chords_around(tube));
}

bool is_of_planes(const MeshData& mesh) {
    const auto normal = [&](std::size_t corner) {
        return &mesh.vertices[mesh.indices[corner] * static_cast<std::size_t>(kVertexFloats) + 3];
    };
    for (std::size_t i = 0; i < mesh.indices.size(); ++i)
        if (!std::equal(normal(i), normal(i) + 3, normal(i - i % 3)))
            return false;
    return true;
}

void lay_along_x(MeshData& mesh) {
    for (std::size_t v = 0; v < mesh.vertices.size(); v += kVertexFloats)
        for (std::size_t part : {0u, 3u, 6u}) { // position, normal, tangent: (x, y, z) -> (y, -x, z), a turn
            float* p = &mesh.vertices[v + part];
            const float x = p[0];
            p[0] = p[1];
            p[1] = -x;
        }
}

} // namespace metamer
