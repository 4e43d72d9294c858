#include "gles/texture.h"

#include <algorithm>
#include <bit>
#include <string>

#include "base/error.h"
#include "gles/check.h"

namespace metamer {

namespace {

bool power_of_two(int side_px) {
    return side_px > 0 && std::has_single_bit(static_cast<unsigned>(side_px));
}

void check_size(int width_px, int height_px, std::size_t bytes) {
    const std::string place = "texture " + std::to_string(width_px) + "x" + std::to_string(height_px);
    if (!power_of_two(width_px) || !power_of_two(height_px))
        throw failure("make", place, "sides must be powers of two");
    GLint allowed = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &allowed);
    const int most = std::min<int>(allowed, kMostTexturePx);
    if (width_px > most || height_px > most)
        throw failure("make", place, "sides must be at most " + std::to_string(most));
    const std::size_t needed = static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px) * 4;
    if (bytes != needed)
        throw failure("make", place,
                      std::to_string(bytes) + " bytes given, " + std::to_string(needed) + " needed");
}

void apply(const Sampling& sampling) {
    const bool linear = sampling.filter == Filter::linear;
    const GLint magnify = linear ? GL_LINEAR : GL_NEAREST;
    const GLint minify =
        !sampling.mipmaps ? magnify : (linear ? GL_LINEAR_MIPMAP_NEAREST : GL_NEAREST_MIPMAP_NEAREST);
    const GLint wrap = sampling.wrap == Wrap::repeat ? GL_REPEAT : GL_CLAMP_TO_EDGE;
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, magnify);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, minify);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap);
    if (sampling.mipmaps)
        glGenerateMipmap(GL_TEXTURE_2D);
}

} // namespace

Texture::Texture(int width_px, int height_px, std::span<const std::uint8_t> rgba, Sampling sampling)
    : width_px_(width_px), height_px_(height_px) {
    check_size(width_px, height_px, rgba.size());
    GLuint name = 0;
    glGenTextures(1, &name);
    texture_ = Handle<&Texture::destroy>(name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, width_px, height_px, 0, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    apply(sampling);
    throw_on_gl_error("make", "texture " + std::to_string(width_px) + "x" + std::to_string(height_px));
}

void Texture::destroy(GLuint texture) {
    glDeleteTextures(1, &texture);
}

void Texture::bind(int unit) const {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, texture_.get());
}

} // namespace metamer
