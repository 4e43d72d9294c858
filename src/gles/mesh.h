// Triangles on the GPU.
#pragma once

#include <GLES2/gl2.h>

#include "gles/handle.h"
#include "gles/mesh_data.h"

namespace metamer {

/// Vertex and index buffer of one MeshData. Move-only.
class Mesh {
public:
    /// Throws failure when the mesh is empty, the sizes are no multiples of a vertex or a triangle, or an
    /// index points behind the last vertex.
    explicit Mesh(const MeshData& data);

    /// Draws every triangle with the current program, attributes at the locations of kMeshAttributes.
    void draw() const;

private:
    static void destroy(GLuint buffer);

    Handle<&Mesh::destroy> vertices_, indices_;
    GLsizei index_count_;
};

} // namespace metamer
