// A mesh before it reaches the GPU: plain numbers, no GL.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace metamer {

/// Floats of one vertex: position(3) normal(3) tangent(3) uv(2).
inline constexpr int kVertexFloats = 11;
inline constexpr int kUvAt = 9; ///< where uv begins among them

/// The attributes in the order of their locations 0 .. 3, for Program.
inline constexpr std::array<const char*, 4> kMeshAttributes = {"a_position", "a_normal", "a_tangent", "a_uv"};

struct MeshData {
    std::vector<float> vertices;        ///< kVertexFloats per vertex
    std::vector<std::uint16_t> indices; ///< three per triangle, front faces counterclockwise
};

} // namespace metamer
