// Shapes, as triangles with normals, tangents and texture coordinates.
#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>

#include "gles/mesh_data.h"

namespace metamer {

/// A point of a surface for u, v in 0 .. 1.
using SurfaceFunction = std::function<glm::vec3(double u, double v)>;

/// Adds a grid of `columns` x `rows` quads over a smooth surface; normals are dp/du x dp/dv, tangents dp/du,
/// u and v the texture coordinates. Throws failure beyond 65536 vertices.
void add_surface(MeshData& mesh, const SurfaceFunction& point, int columns, int rows);

/// Adds a flat quadrilateral, corners counterclockwise as seen from outside; uv (0,0) at the first, (1,0) at
/// the second.
void add_quad(MeshData& mesh, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d);

/// Adds an upright box turned by `turn_rad` about the vertical through `center`.
void add_box(MeshData& mesh, const glm::vec3& center, const glm::vec3& size, double turn_rad = 0);

/// Adds a body of revolution about the vertical through `foot`: (radius, height) from bottom to top, a smooth
/// curve through the points; a point given twice makes a crease. u runs around, v along the profile.
void add_lathe(MeshData& mesh, const glm::vec3& foot, std::span<const glm::vec2> profile);

void add_sphere(MeshData& mesh, const glm::vec3& center, double radius);

/// Adds a ring lying flat: `radius` to the middle of its tube of radius `tube`.
void add_torus(MeshData& mesh, const glm::vec3& center, double radius, double tube);

/// Whether all its triangles are flat: the same normal at their three corners.
bool is_of_planes(const MeshData& mesh);

/// Swaps axes of a whole mesh: what stood upright along y lies along x.
void lay_along_x(MeshData& mesh);

} // namespace metamer
