#include "gles/check.h"

#include "base/error.h"
#include "base/printed.h"

namespace metamer {

namespace {
/// A lost context may repeat one error for ever: no GL has more flags than this.
constexpr int kMostFlags = 16;

std::string unknown(const char* kind, GLenum value) {
    return printed("%s 0x%04x", kind, value);
}
} // namespace

std::string gl_error_name(GLenum error) {
    switch (error) {
    case GL_NO_ERROR:
        return "GL_NO_ERROR";
    case GL_INVALID_ENUM:
        return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE:
        return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION:
        return "GL_INVALID_OPERATION";
    case GL_INVALID_FRAMEBUFFER_OPERATION:
        return "GL_INVALID_FRAMEBUFFER_OPERATION";
    case GL_OUT_OF_MEMORY:
        return "GL_OUT_OF_MEMORY";
    default:
        return unknown("GL error", error);
    }
}

std::string framebuffer_status_name(GLenum status) {
    switch (status) {
    case GL_FRAMEBUFFER_COMPLETE:
        return "GL_FRAMEBUFFER_COMPLETE";
    case GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT:
        return "GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT";
    case GL_FRAMEBUFFER_INCOMPLETE_DIMENSIONS:
        return "GL_FRAMEBUFFER_INCOMPLETE_DIMENSIONS";
    case GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT:
        return "GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT";
    case GL_FRAMEBUFFER_UNSUPPORTED:
        return "GL_FRAMEBUFFER_UNSUPPORTED";
    default:
        return unknown("framebuffer status", status);
    }
}

void throw_on_gl_error(const std::string& verb, const std::string& object) {
    std::string names;
    for (int flag = 0; flag < kMostFlags; ++flag) {
        const GLenum error = glGetError();
        if (error == GL_NO_ERROR)
            break;
        names += (names.empty() ? "" : ", ") + gl_error_name(error);
    }
    if (!names.empty())
        throw failure(verb, object, names);
}

} // namespace metamer
