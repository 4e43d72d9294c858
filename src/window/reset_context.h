// A context that tells when it was lost.
#pragma once

#include <EGL/egl.h>
#include <memory>

namespace metamer {

/// EGL_EXT_create_context_robustness, which SDL does not ask for: without it the GPU's reset is never told
/// (glGetGraphicsResetStatus says GL_NO_ERROR for good).
class ResetContext {
public:
    /// An OpenGL ES 2 context with reset notification, and robust access where that can be had besides, of
    /// the current one's config, made current in its place on the same surface. None where EGL cannot: the
    /// current one stays.
    static std::unique_ptr<ResetContext> in_place_of_current();

    ResetContext(const ResetContext&) = delete;
    ResetContext& operator=(const ResetContext&) = delete;
    ~ResetContext();

    /// SDL makes its own context current again when it replaces the surface (KMSDRM): then on to that
    /// surface. Returns whether the context is current.
    bool keep_current() const;

private:
    ResetContext(EGLDisplay display, EGLContext context) : display_(display), context_(context) {}

    EGLDisplay display_;
    EGLContext context_;
};

} // namespace metamer
