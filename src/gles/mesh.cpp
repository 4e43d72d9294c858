#include "gles/mesh.h"

#include <algorithm>
#include <cstdint>
#include <string>

#include "base/error.h"
#include "gles/check.h"

namespace metamer {

namespace {

constexpr std::array<GLint, kMeshAttributes.size()> kComponents = {3, 3, 3, 2};

void check(const MeshData& data) {
    const std::size_t floats = data.vertices.size(), indices = data.indices.size();
    if (floats == 0 || floats % kVertexFloats != 0)
        throw failure("make", "mesh", std::to_string(floats) + " floats are no vertices of 11");
    if (indices == 0 || indices % 3 != 0)
        throw failure("make", "mesh", std::to_string(indices) + " indices are no triangles");
    const std::size_t vertices = floats / kVertexFloats;
    const std::uint16_t greatest = *std::max_element(data.indices.begin(), data.indices.end());
    if (greatest >= vertices)
        throw failure("make", "mesh",
                      "index " + std::to_string(greatest) + " of " + std::to_string(vertices) + " vertices");
}

GLuint new_buffer() {
    GLuint name = 0;
    glGenBuffers(1, &name);
    return name;
}

} // namespace

Mesh::Mesh(const MeshData& data) : index_count_(static_cast<GLsizei>(data.indices.size())) {
    check(data);
    vertices_ = Handle<&Mesh::destroy>(new_buffer());
    indices_ = Handle<&Mesh::destroy>(new_buffer());
    glBindBuffer(GL_ARRAY_BUFFER, vertices_.get());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(data.vertices.size() * sizeof(float)),
                 data.vertices.data(), GL_STATIC_DRAW);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.get());
    glBufferData(GL_ELEMENT_ARRAY_BUFFER,
                 static_cast<GLsizeiptr>(data.indices.size() * sizeof(std::uint16_t)), data.indices.data(),
                 GL_STATIC_DRAW);
    throw_on_gl_error("make", "mesh");
}

void Mesh::destroy(GLuint buffer) {
    glDeleteBuffers(1, &buffer);
}

void Mesh::draw() const {
    glBindBuffer(GL_ARRAY_BUFFER, vertices_.get());
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.get());
    std::uintptr_t offset = 0;
    for (std::size_t i = 0; i < kComponents.size(); ++i) {
        const auto location = static_cast<GLuint>(i);
        glEnableVertexAttribArray(location);
        glVertexAttribPointer(location, kComponents[i], GL_FLOAT, GL_FALSE, kVertexFloats * sizeof(float),
                              reinterpret_cast<const void*>(offset));
        offset += static_cast<std::uintptr_t>(kComponents[i]) * sizeof(float);
    }
    glDrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_SHORT, nullptr);
}

} // namespace metamer
