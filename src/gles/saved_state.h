// GL state that a helper drawing changes, put back when it is done.
#pragma once

#include <GLES2/gl2.h>
#include <array>

namespace metamer {

/// Framebuffer, texture of unit 0, active unit (0 meanwhile), viewport, clear color, blending and dithering
/// (off meanwhile), scissor test and depth test as they are now, and again at the end of its life. Make it
/// before the objects that change them, so that it outlives them.
class SavedState {
public:
    SavedState()
        : scissor_(glIsEnabled(GL_SCISSOR_TEST)),
          depth_(glIsEnabled(GL_DEPTH_TEST)),
          blend_(glIsEnabled(GL_BLEND)),
          dither_(glIsEnabled(GL_DITHER)) {
        glDisable(GL_BLEND);
        glDisable(GL_DITHER);
        glGetIntegerv(GL_ACTIVE_TEXTURE, &unit_);
        glActiveTexture(GL_TEXTURE0);
        glGetIntegerv(GL_FRAMEBUFFER_BINDING, &framebuffer_);
        glGetIntegerv(GL_TEXTURE_BINDING_2D, &texture_); // a framebuffer may be a texture: see Framebuffer
        glGetIntegerv(GL_VIEWPORT, viewport_.data());
        glGetFloatv(GL_COLOR_CLEAR_VALUE, clear_.data());
    }
    SavedState(const SavedState&) = delete;
    SavedState& operator=(const SavedState&) = delete;
    ~SavedState() {
        glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(framebuffer_));
        glActiveTexture(GL_TEXTURE0);
        glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(texture_));
        glActiveTexture(static_cast<GLenum>(unit_));
        glViewport(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
        glClearColor(clear_[0], clear_[1], clear_[2], clear_[3]);
        (scissor_ ? glEnable : glDisable)(GL_SCISSOR_TEST);
        (depth_ ? glEnable : glDisable)(GL_DEPTH_TEST);
        (blend_ ? glEnable : glDisable)(GL_BLEND);
        (dither_ ? glEnable : glDisable)(GL_DITHER);
    }

private:
    GLboolean scissor_, depth_, blend_, dither_;
    GLint unit_ = GL_TEXTURE0, framebuffer_ = 0, texture_ = 0;
    std::array<GLint, 4> viewport_{};
    std::array<GLfloat, 4> clear_{};
};

} // namespace metamer
