// What is drawn into.
#pragma once

#include <GLES2/gl2.h>
#include <cstdint>
#include <optional>
#include <vector>

#include "gles/handle.h"

namespace metamer {

enum class DepthBuffer { none, depth16 };

/// `target`: only drawn into and read back; `target_rgb565`: the same with 16 bits a pixel, core ES 2 (OpenGL
/// ES 2.0.25 table 4.5). `texture`: also sampled afterwards, texel by texel (shadow maps); `picture`: the
/// same with a linear filter.
enum class ColorBuffer { target, target_rgb565, texture, picture };

/// An RGBA8 color buffer, with GL_DEPTH_COMPONENT16 if asked for. Move-only.
class Framebuffer {
public:
    /// A `target` is a renderbuffer where GL_OES_rgb8_rgba8 is there, else a texture, clamped and without
    /// mipmaps, which core ES 2 allows at any size (OpenGL ES 2.0.25 section 3.8.2). A `texture`
    /// and a `picture` have power-of-two sides, clamp. Throws failure: a size outside 1 .. the context's
    /// limits, no power of two, or an incomplete framebuffer by its status's name. Leaves the new framebuffer
    /// bound; its contents are undefined until cleared.
    Framebuffer(int width_px, int height_px, DepthBuffer depth = DepthBuffer::none,
                ColorBuffer color = ColorBuffer::target);

    /// Binds it and sets the viewport to all of it.
    void bind() const;

    /// Binds the color texture to texture unit GL_TEXTURE0 + unit. Throws failure unless made with
    /// ColorBuffer::texture or picture.
    void bind_texture(int unit) const;

    /// width_px * height_px * 4 bytes, the top row (greatest y) first. Binds it.
    std::vector<std::uint8_t> read_rgba() const;

    int width_px() const { return width_px_; }
    int height_px() const { return height_px_; }

private:
    static void destroy_framebuffer(GLuint framebuffer);
    static void destroy_renderbuffer(GLuint renderbuffer);
    static void destroy_texture(GLuint texture);
    void attach_color_texture(GLint filter);
    void attach_color_renderbuffer(GLenum format);
    void attach_depth();

    int width_px_, height_px_;
    bool sampled_;
    Handle<&Framebuffer::destroy_renderbuffer> color_renderbuffer_, depth_renderbuffer_;
    Handle<&Framebuffer::destroy_texture> color_texture_;
    Handle<&Framebuffer::destroy_framebuffer> framebuffer_;
};

/// A `picture` with room for this many pixels in its lower left corner, its sides powers of two: the one that
/// is there, or a new one in its place where that has other sides. Throws what Framebuffer throws.
Framebuffer& picture_with_room(std::optional<Framebuffer>& picture, int width_px, int height_px,
                               DepthBuffer depth);

/// Whether this GPU has room for such a picture.
bool has_room_for_picture(int width_px, int height_px);

} // namespace metamer
