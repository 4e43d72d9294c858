// GL errors as exceptions.
#pragma once

#include <GLES2/gl2.h>
#include <string>

namespace metamer {

/// `GL_INVALID_VALUE` and so on; `GL error 0x1234` for one not of OpenGL ES 2.0.
std::string gl_error_name(GLenum error);

/// `GL_FRAMEBUFFER_UNSUPPORTED` and so on; `framebuffer status 0x1234` for one not of OpenGL ES 2.0.
std::string framebuffer_status_name(GLenum status);

/// Throws failure where glGetError has something to say: throw_on_gl_error("draw", "the loaf") gives
/// `cannot draw the loaf: GL_INVALID_OPERATION`. Clears every flag (OpenGL ES 2.0.25 section 2.5: there may
/// be several) and names all of them.
void throw_on_gl_error(const std::string& verb, const std::string& object);

} // namespace metamer
