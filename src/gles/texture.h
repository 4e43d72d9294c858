// A picture that shaders read.
#pragma once

#include <GLES2/gl2.h>
#include <bit>
#include <cstdint>
#include <span>

#include "gles/handle.h"

namespace metamer {

enum class Filter { nearest, linear };
enum class Wrap { clamp, repeat };

/// The greatest side of a texture on the oldest GPU that counts (VideoCore IV): 2048 (DESIGN.md section 5).
inline constexpr int kMostTexturePx = 2048;

/// The least power of two that has room for `px` >= 1: the side of a texture for pictures of any size.
inline int texture_side(int px) {
    return static_cast<int>(std::bit_ceil(static_cast<unsigned>(px)));
}

struct Sampling {
    Filter filter = Filter::linear;
    Wrap wrap = Wrap::clamp;
    bool mipmaps = false; ///< made by GL; minified with the nearest level, `filter` inside it
};

/// An RGBA8 texture. Move-only.
class Texture {
public:
    /// `rgba`: width_px * height_px * 4 bytes, first row at t = 0. Sides must be powers of two, 1 ..
    /// kMostTexturePx and within GL_MAX_TEXTURE_SIZE: core ES 2 samples others only with clamp and no mipmaps
    /// (OpenGL ES 2.0.25 section 3.8.2), and the oldest GPUs slowly. Throws failure with the size.
    Texture(int width_px, int height_px, std::span<const std::uint8_t> rgba, Sampling sampling = {});

    /// Binds to GL_TEXTURE_2D of texture unit GL_TEXTURE0 + unit.
    void bind(int unit) const;

    int width_px() const { return width_px_; }
    int height_px() const { return height_px_; }

private:
    static void destroy(GLuint texture);

    Handle<&Texture::destroy> texture_;
    int width_px_, height_px_;
};

} // namespace metamer
