#include "gles/framebuffer.h"

#include <GLES2/gl2ext.h>
#include <algorithm>
#include <bit>
#include <string>

#include "base/error.h"
#include "gles/check.h"
#include "gles/extensions.h"
#include "gles/texture.h"

namespace metamer {

namespace {

std::string place(int width_px, int height_px) {
    return "framebuffer " + std::to_string(width_px) + "x" + std::to_string(height_px);
}

int integer(GLenum name) {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

/// The greatest width and height: of the buffers and of the viewport.
int most_px(bool color_is_texture, int side) {
    GLint viewport[2] = {};
    glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport);
    return std::min({integer(color_is_texture ? GL_MAX_TEXTURE_SIZE : GL_MAX_RENDERBUFFER_SIZE),
                     integer(GL_MAX_RENDERBUFFER_SIZE), viewport[side]});
}

void check_size(int width_px, int height_px, bool color_is_texture, bool sampled) {
    const int sides[2] = {width_px, height_px};
    for (int i = 0; i < 2; ++i) {
        const int most = most_px(color_is_texture, i);
        if (sides[i] < 1 || sides[i] > most)
            throw failure("make", place(width_px, height_px), "sides must be 1 .. " + std::to_string(most));
        if (sampled && !std::has_single_bit(static_cast<unsigned>(sides[i])))
            throw failure("make", place(width_px, height_px),
                          "sides must be powers of two where it is sampled");
    }
}

} // namespace

Framebuffer::Framebuffer(int width_px, int height_px, DepthBuffer depth, ColorBuffer color)
    : width_px_(width_px),
      height_px_(height_px),
      sampled_(color == ColorBuffer::texture || color == ColorBuffer::picture) {
    const bool rgb565 = color == ColorBuffer::target_rgb565;
    const bool color_is_texture = sampled_ || (!rgb565 && !use_gl_extension("GL_OES_rgb8_rgba8"));
    check_size(width_px, height_px, color_is_texture, sampled_);
    GLuint name = 0;
    glGenFramebuffers(1, &name);
    framebuffer_ = Handle<&Framebuffer::destroy_framebuffer>(name);
    glBindFramebuffer(GL_FRAMEBUFFER, name);
    if (color_is_texture)
        attach_color_texture(color == ColorBuffer::picture ? GL_LINEAR : GL_NEAREST);
    else
        attach_color_renderbuffer(rgb565 ? GL_RGB565 : GL_RGBA8_OES);
    if (depth == DepthBuffer::depth16)
        attach_depth();
    throw_on_gl_error("make", place(width_px, height_px));
    if (const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER); status != GL_FRAMEBUFFER_COMPLETE)
        throw failure("make", place(width_px, height_px), framebuffer_status_name(status));
    glViewport(0, 0, width_px, height_px);
}

void Framebuffer::attach_color_texture(GLint filter) {
    GLuint name = 0;
    glGenTextures(1, &name);
    color_texture_ = Handle<&Framebuffer::destroy_texture>(name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, width_px_, height_px_, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, name, 0);
}

void Framebuffer::attach_color_renderbuffer(GLenum format) {
    GLuint name = 0;
    glGenRenderbuffers(1, &name);
    color_renderbuffer_ = Handle<&Framebuffer::destroy_renderbuffer>(name);
    glBindRenderbuffer(GL_RENDERBUFFER, name);
    glRenderbufferStorage(GL_RENDERBUFFER, format, width_px_, height_px_);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, name);
}

void Framebuffer::attach_depth() {
    GLuint name = 0;
    glGenRenderbuffers(1, &name);
    depth_renderbuffer_ = Handle<&Framebuffer::destroy_renderbuffer>(name);
    glBindRenderbuffer(GL_RENDERBUFFER, name);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT16, width_px_, height_px_);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, name);
}

void Framebuffer::destroy_framebuffer(GLuint framebuffer) {
    glDeleteFramebuffers(1, &framebuffer);
}

void Framebuffer::destroy_renderbuffer(GLuint renderbuffer) {
    glDeleteRenderbuffers(1, &renderbuffer);
}

void Framebuffer::destroy_texture(GLuint texture) {
    glDeleteTextures(1, &texture);
}

void Framebuffer::bind() const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.get());
    glViewport(0, 0, width_px_, height_px_);
}

void Framebuffer::bind_texture(int unit) const {
    if (!sampled_)
        throw failure("sample", place(width_px_, height_px_), "it was not made as a texture");
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, color_texture_.get());
}

std::vector<std::uint8_t> Framebuffer::read_rgba() const {
    bind();
    const std::size_t row_bytes = static_cast<std::size_t>(width_px_) * 4;
    std::vector<std::uint8_t> rgba(row_bytes * static_cast<std::size_t>(height_px_));
    // Rows of RGBA8 are multiples of four bytes: GL_PACK_ALIGNMENT's default adds no padding.
    glReadPixels(0, 0, width_px_, height_px_, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    throw_on_gl_error("read", place(width_px_, height_px_));
    for (int top = 0, bottom = height_px_ - 1; top < bottom; ++top, --bottom) {
        const auto a = rgba.begin() + static_cast<std::ptrdiff_t>(row_bytes) * top;
        const auto b = rgba.begin() + static_cast<std::ptrdiff_t>(row_bytes) * bottom;
        std::swap_ranges(a, a + static_cast<std::ptrdiff_t>(row_bytes), b);
    }
    return rgba;
}

Framebuffer& picture_with_room(std::optional<Framebuffer>& picture, int width_px, int height_px,
                               DepthBuffer depth) {
    const int width = texture_side(width_px), height = texture_side(height_px);
    if (!picture || picture->width_px() != width || picture->height_px() != height)
        picture.emplace(width, height, depth, ColorBuffer::picture);
    return *picture;
}

bool has_room_for_picture(int width_px, int height_px) {
    return texture_side(width_px) <= most_px(true, 0) && texture_side(height_px) <= most_px(true, 1);
}

} // namespace metamer
