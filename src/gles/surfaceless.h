// An OpenGL ES 2 context without any window.
#pragma once

#include <EGL/egl.h>

namespace metamer {

/// An EGL display and an OpenGL ES 2 context that needs no display server. Several may exist at once; the
/// context that was constructed, or asked for by make_current(), last is the thread's current one. GL objects
/// must go before the context that they were made in.
class Surfaceless {
public:
    /// Tries Mesa's surfaceless platform (EGL_MESA_platform_surfaceless), the first device
    /// (EGL_EXT_platform_device), the default display, in that order, and takes the first that gives an ES 2
    /// context; without EGL_KHR_surfaceless_context it is made current on a 1x1 pbuffer. Throws no_gl naming,
    /// for each display tried, the call that failed and EGL's error. The driver stays mapped until the
    /// process ends (keep_mapped.h).
    Surfaceless();
    Surfaceless(Surfaceless&& other) noexcept;
    Surfaceless& operator=(Surfaceless&& other) noexcept;
    Surfaceless(const Surfaceless&) = delete;
    Surfaceless& operator=(const Surfaceless&) = delete;
    ~Surfaceless();

    /// Makes the context current on this thread again. Throws no_gl.
    void make_current() const;

private:
    void close() noexcept;

    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLContext context_ = EGL_NO_CONTEXT;
    EGLSurface surface_ = EGL_NO_SURFACE; ///< the pbuffer, where one is needed
};

} // namespace metamer
