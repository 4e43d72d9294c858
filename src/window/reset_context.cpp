#include "window/reset_context.h"

#include <EGL/eglext.h>
#include <array>

#include "gles/extensions.h"

namespace metamer {

namespace {

EGLConfig current_config(EGLDisplay display) {
    EGLint id = 0;
    if (eglQueryContext(display, eglGetCurrentContext(), EGL_CONFIG_ID, &id) != EGL_TRUE)
        return EGL_NO_CONFIG_KHR;
    const EGLint wanted[] = {EGL_CONFIG_ID, id, EGL_NONE};
    EGLConfig config = EGL_NO_CONFIG_KHR;
    EGLint count = 0;
    return eglChooseConfig(display, wanted, &config, 1, &count) == EGL_TRUE && count == 1 ? config
                                                                                          : EGL_NO_CONFIG_KHR;
}

EGLContext robust_context(EGLDisplay display, EGLConfig config) {
    eglBindAPI(EGL_OPENGL_ES_API);
    for (const EGLint access : {EGL_TRUE, EGL_FALSE}) {
        const std::array<EGLint, 7> wanted = {EGL_CONTEXT_CLIENT_VERSION,
                                              2,
                                              EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY_EXT,
                                              EGL_LOSE_CONTEXT_ON_RESET_EXT,
                                              EGL_CONTEXT_OPENGL_ROBUST_ACCESS_EXT,
                                              access,
                                              EGL_NONE};
        if (EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, wanted.data()))
            return context;
    }
    return EGL_NO_CONTEXT;
}

} // namespace

std::unique_ptr<ResetContext> ResetContext::in_place_of_current() {
    EGLDisplay display = eglGetCurrentDisplay();
    if (display == EGL_NO_DISPLAY ||
        !use_listed_extension(eglQueryString(display, EGL_EXTENSIONS), "EGL_EXT_create_context_robustness"))
        return nullptr;
    EGLConfig config = current_config(display);
    EGLContext context = config == EGL_NO_CONFIG_KHR ? EGL_NO_CONTEXT : robust_context(display, config);
    if (context == EGL_NO_CONTEXT)
        return nullptr;
    std::unique_ptr<ResetContext> reset(new ResetContext(display, context));
    // A failed eglMakeCurrent leaves what was current (EGL 1.5 section 3.7.3).
    return reset->keep_current() ? std::move(reset) : nullptr;
}

ResetContext::~ResetContext() {
    if (eglGetCurrentContext() == context_)
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);
}

bool ResetContext::keep_current() const {
    EGLSurface surface = eglGetCurrentSurface(EGL_DRAW);
    return eglGetCurrentContext() == context_ ||
           eglMakeCurrent(display_, surface, surface, context_) == EGL_TRUE;
}

} // namespace metamer
