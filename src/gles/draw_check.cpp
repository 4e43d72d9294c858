#include "gles/draw_check.h"

#include <GLES2/gl2.h>
#include <array>
#include <utility>

#include "gles/framebuffer.h"
#include "gles/mesh.h"

namespace metamer {

namespace {

/// What draws() changes, put back at the end of its life.
class SavedState {
public:
    SavedState() : scissor_(glIsEnabled(GL_SCISSOR_TEST)), depth_(glIsEnabled(GL_DEPTH_TEST)) {
        glGetIntegerv(GL_FRAMEBUFFER_BINDING, &framebuffer_);
        glGetIntegerv(GL_TEXTURE_BINDING_2D, &texture_); // a framebuffer may be a texture: see Framebuffer
        glGetIntegerv(GL_VIEWPORT, viewport_.data());
        glGetFloatv(GL_COLOR_CLEAR_VALUE, clear_.data());
    }
    SavedState(const SavedState&) = delete;
    SavedState& operator=(const SavedState&) = delete;
    ~SavedState() {
        glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(framebuffer_));
        glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(texture_));
        glViewport(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
        glClearColor(clear_[0], clear_[1], clear_[2], clear_[3]);
        (scissor_ ? glEnable : glDisable)(GL_SCISSOR_TEST);
        (depth_ ? glEnable : glDisable)(GL_DEPTH_TEST);
    }

private:
    GLboolean scissor_, depth_;
    GLint framebuffer_ = 0, texture_ = 0;
    std::array<GLint, 4> viewport_{};
    std::array<GLfloat, 4> clear_{};
};

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
    const Framebuffer pixel(1, 1);
    const Mesh mesh(cover());
    pixel.bind();
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_DEPTH_TEST);
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT);
    program.use();
    mesh.draw();
    return pixel.read_rgba()[3] == 255;
}

} // namespace metamer
