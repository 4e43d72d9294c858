#include "gles/draw_check.h"

#include <GLES2/gl2.h>
#include <array>
#include <cstdint>
#include <utility>

#include "gles/framebuffer.h"
#include "gles/mesh.h"
#include "gles/saved_state.h"
#include "gles/texture.h"

namespace metamer {

namespace {

constexpr std::array<std::uint8_t, 4> kWhite{255, 255, 255, 255};

// One triangle that covers the whole of clip space; normals and tangents of some direction, for shaders that
// turn them.
MeshData cover() {
    MeshData mesh;
    for (const auto& [x, y] : {std::pair{-1.f, -1.f}, {3.f, -1.f}, {-1.f, 3.f}})
        mesh.vertices.insert(mesh.vertices.end(), {x, y, 0, 0, 0, 1, 1, 0, 0, 0.5f, 0.5f});
    mesh.indices = {0, 1, 2};
    return mesh;
}

} // namespace

bool draws(const Program& program) {
    const SavedState saved;
    const Framebuffer pixel(1, 1, DepthBuffer::depth16);
    const Mesh mesh(cover());
    pixel.bind();
    const Texture white(1, 1, kWhite); // what a new program's samplers read
    white.bind(0);
    glDisable(GL_SCISSOR_TEST);
    glEnable(GL_DEPTH_TEST); // as scenes are drawn: some drivers compile a program anew for another state
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    program.use();
    mesh.draw();
    return pixel.read_rgba()[3] == 255;
}

} // namespace metamer
