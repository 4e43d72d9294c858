#include "gles/info.h"

#include <GLES2/gl2.h>

#include "gles/extensions.h"
#include "gles/precision_probe.h"

namespace metamer {

namespace {

std::string text(GLenum name) {
    const GLubyte* value = glGetString(name);
    return value == nullptr ? "" : reinterpret_cast<const char*>(value);
}

int integer(GLenum name) {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

FragmentPrecision reported(GLenum type) {
    GLint range[2] = {}, bits = 0;
    glGetShaderPrecisionFormat(GL_FRAGMENT_SHADER, type, range, &bits);
    return {range[0], range[1], bits};
}

GlLimits limits() {
    GLint viewport[2] = {};
    glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport);
    return {
        .max_fragment_uniform_vectors = integer(GL_MAX_FRAGMENT_UNIFORM_VECTORS),
        .max_vertex_uniform_vectors = integer(GL_MAX_VERTEX_UNIFORM_VECTORS),
        .max_varying_vectors = integer(GL_MAX_VARYING_VECTORS),
        .max_vertex_attribs = integer(GL_MAX_VERTEX_ATTRIBS),
        .max_texture_image_units = integer(GL_MAX_TEXTURE_IMAGE_UNITS),
        .max_vertex_texture_image_units = integer(GL_MAX_VERTEX_TEXTURE_IMAGE_UNITS),
        .max_combined_texture_image_units = integer(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS),
        .max_texture_size_px = integer(GL_MAX_TEXTURE_SIZE),
        .max_renderbuffer_size_px = integer(GL_MAX_RENDERBUFFER_SIZE),
        .max_viewport_width_px = viewport[0],
        .max_viewport_height_px = viewport[1],
    };
}

} // namespace

std::string gl_renderer() {
    return text(GL_RENDERER);
}

GlInfo gl_info() {
    GlInfo info;
    info.vendor = text(GL_VENDOR);
    info.renderer = gl_renderer();
    info.version = text(GL_VERSION);
    info.shading_language = text(GL_SHADING_LANGUAGE_VERSION);
    info.lowp = reported(GL_LOW_FLOAT);
    info.mediump = reported(GL_MEDIUM_FLOAT);
    info.highp = reported(GL_HIGH_FLOAT);
    info.measured_mediump_bits = measured_fragment_bits(Precision::mediump);
    info.measured_highp_bits = info.highp.reported_bits > 0 ? measured_fragment_bits(Precision::highp) : 0;
    info.limits = limits();
    info.extensions = present_gl_extensions();
    info.extensions_used = used_gl_extensions();
    return info;
}

} // namespace metamer
