#include "gles/surfaceless.h"

#include <EGL/eglext.h>
#include <map>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/printed.h"
#include "gles/extensions.h"
#include "gles/keep_mapped.h"

namespace metamer {

namespace {

std::string egl_error_name(EGLint error) {
    static const std::map<EGLint, const char*> names = {
        {EGL_SUCCESS, "EGL_SUCCESS"},
        {EGL_NOT_INITIALIZED, "EGL_NOT_INITIALIZED"},
        {EGL_BAD_ACCESS, "EGL_BAD_ACCESS"},
        {EGL_BAD_ALLOC, "EGL_BAD_ALLOC"},
        {EGL_BAD_ATTRIBUTE, "EGL_BAD_ATTRIBUTE"},
        {EGL_BAD_CONFIG, "EGL_BAD_CONFIG"},
        {EGL_BAD_CONTEXT, "EGL_BAD_CONTEXT"},
        {EGL_BAD_CURRENT_SURFACE, "EGL_BAD_CURRENT_SURFACE"},
        {EGL_BAD_DISPLAY, "EGL_BAD_DISPLAY"},
        {EGL_BAD_MATCH, "EGL_BAD_MATCH"},
        {EGL_BAD_NATIVE_PIXMAP, "EGL_BAD_NATIVE_PIXMAP"},
        {EGL_BAD_NATIVE_WINDOW, "EGL_BAD_NATIVE_WINDOW"},
        {EGL_BAD_PARAMETER, "EGL_BAD_PARAMETER"},
        {EGL_BAD_SURFACE, "EGL_BAD_SURFACE"},
        {EGL_CONTEXT_LOST, "EGL_CONTEXT_LOST"},
    };
    if (const auto found = names.find(error); found != names.end())
        return found->second;
    return printed("EGL error 0x%04x", static_cast<unsigned>(error));
}

/// Thrown inside this file: what went wrong with one display.
struct Refused {
    std::string why;
};

[[noreturn]] void refuse(const char* call) {
    throw Refused{call + (": " + egl_error_name(eglGetError()))};
}

/// EGL gives everyone the same display, and eglTerminate ends it for everyone: the last one turns the light
/// off.
class DisplayUsers {
public:
    void enter(EGLDisplay display) {
        const std::lock_guard lock(mutex_);
        if (eglInitialize(display, nullptr, nullptr) != EGL_TRUE)
            refuse("eglInitialize");
        keep_libraries_mapped();
        ++users_[display];
    }
    void leave(EGLDisplay display) noexcept {
        const std::lock_guard lock(mutex_);
        if (--users_[display] == 0)
            eglTerminate(display);
    }

private:
    std::mutex mutex_;
    std::map<EGLDisplay, int> users_;
};

DisplayUsers& display_users() {
    static DisplayUsers users;
    return users;
}

EGLDisplay platform_display(EGLenum platform, void* native) {
    const auto get =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
    if (get == nullptr)
        throw Refused{"EGL_EXT_platform_base is missing"};
    return get(platform, native, nullptr);
}

EGLDisplay mesa_surfaceless_display() {
    return platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY);
}

EGLDisplay first_device_display() {
    const auto query = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
    EGLDeviceEXT device = nullptr;
    EGLint count = 0;
    if (query == nullptr)
        throw Refused{"EGL_EXT_device_enumeration is missing"};
    if (query(1, &device, &count) != EGL_TRUE)
        refuse("eglQueryDevicesEXT");
    if (count < 1)
        throw Refused{"eglQueryDevicesEXT: no device"};
    return platform_display(EGL_PLATFORM_DEVICE_EXT, device);
}

EGLDisplay default_display() {
    return eglGetDisplay(EGL_DEFAULT_DISPLAY);
}

EGLConfig any_es2_config(EGLDisplay display) {
    // Drawing goes to framebuffer objects: of the config only a pbuffer is wanted, in case.
    const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_ES2_BIT,
                             EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (eglChooseConfig(display, wanted, &config, 1, &count) != EGL_TRUE)
        refuse("eglChooseConfig");
    if (count < 1)
        throw Refused{"eglChooseConfig: no config for OpenGL ES 2 and pbuffers"};
    return config;
}

EGLContext es2_context(EGLDisplay display, EGLConfig config) {
    if (eglBindAPI(EGL_OPENGL_ES_API) != EGL_TRUE)
        refuse("eglBindAPI");
    const EGLint version_2[] = {EGL_CONTEXT_CLIENT_VERSION, 2, EGL_NONE};
    EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, version_2);
    if (context == EGL_NO_CONTEXT)
        refuse("eglCreateContext");
    return context;
}

EGLSurface surface_if_needed(EGLDisplay display, EGLConfig config) {
    if (use_listed_extension(eglQueryString(display, EGL_EXTENSIONS), "EGL_KHR_surfaceless_context"))
        return EGL_NO_SURFACE;
    const EGLint smallest[] = {EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE};
    EGLSurface surface = eglCreatePbufferSurface(display, config, smallest);
    if (surface == EGL_NO_SURFACE)
        refuse("eglCreatePbufferSurface");
    return surface;
}

struct Platform {
    const char* name;
    EGLDisplay (*display)();
};
constexpr Platform kPlatforms[] = {
    {"surfaceless platform", mesa_surfaceless_display},
    {"first device", first_device_display},
    {"default display", default_display},
};

} // namespace

Surfaceless::Surfaceless() {
    std::string causes;
    for (const Platform& platform : kPlatforms) {
        try {
            EGLDisplay display = platform.display();
            if (display == EGL_NO_DISPLAY)
                refuse("no display");
            display_users().enter(display);
            display_ = display;
            const EGLConfig config = any_es2_config(display_);
            context_ = es2_context(display_, config);
            surface_ = surface_if_needed(display_, config);
            if (eglMakeCurrent(display_, surface_, surface_, context_) != EGL_TRUE)
                refuse("eglMakeCurrent");
            return;
        } catch (const Refused& refused) {
            close();
            causes += (causes.empty() ? "" : "; ") + std::string(platform.name) + ": " + refused.why;
        }
    }
    throw no_gl("open", "an OpenGL ES 2 context", causes);
}

Surfaceless::Surfaceless(Surfaceless&& other) noexcept
    : display_(std::exchange(other.display_, EGL_NO_DISPLAY)),
      context_(std::exchange(other.context_, EGL_NO_CONTEXT)),
      surface_(std::exchange(other.surface_, EGL_NO_SURFACE)) {}

Surfaceless& Surfaceless::operator=(Surfaceless&& other) noexcept {
    if (this != &other) {
        close();
        display_ = std::exchange(other.display_, EGL_NO_DISPLAY);
        context_ = std::exchange(other.context_, EGL_NO_CONTEXT);
        surface_ = std::exchange(other.surface_, EGL_NO_SURFACE);
    }
    return *this;
}

Surfaceless::~Surfaceless() {
    close();
}

void Surfaceless::make_current() const {
    if (eglMakeCurrent(display_, surface_, surface_, context_) != EGL_TRUE)
        throw no_gl("use", "the OpenGL ES 2 context", "eglMakeCurrent: " + egl_error_name(eglGetError()));
}

void Surfaceless::close() noexcept {
    if (display_ == EGL_NO_DISPLAY)
        return;
    if (context_ != EGL_NO_CONTEXT && eglGetCurrentContext() == context_)
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (surface_ != EGL_NO_SURFACE)
        eglDestroySurface(display_, surface_);
    if (context_ != EGL_NO_CONTEXT)
        eglDestroyContext(display_, context_);
    display_users().leave(display_);
    display_ = EGL_NO_DISPLAY;
    context_ = EGL_NO_CONTEXT;
    surface_ = EGL_NO_SURFACE;
}

} // namespace metamer
