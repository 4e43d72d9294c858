// A linked pair of shaders and its uniforms.
#pragma once

#include <GLES2/gl2.h>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "gles/handle.h"
#include "gles/shader_source.h"

namespace metamer {

/// A uniform that the linker kept.
struct ActiveUniform {
    std::string name; ///< without the `[0]` of arrays
    GLenum type;      ///< GL_FLOAT_VEC3, GL_SAMPLER_2D, ...
    int size;         ///< array elements, 1 for no array
};

/// Compiled and linked on construction. set() makes the program the current one and writes the uniform; a
/// uniform that the program does not have (dropped by the compiler, or never there) is silently left alone,
/// as GL does.
class Program {
public:
    /// `attributes[i]` is bound to location i. Throws failure("compile" or "link", "shaders_es/x.frag", log)
    /// with the log's places rewritten to files (shader_source.h), in one line.
    Program(const ComposedShader& vertex, const ComposedShader& fragment,
            std::span<const char* const> attributes);

    /// glUseProgram.
    void use() const;

    /// The uniform's location, -1 where the program has none by that name. Looked up once per name.
    GLint uniform(const char* name) const;

    void set(const char* name, int value) const; ///< a sampler's texture unit, or an int
    void set(const char* name, float value) const;
    void set(const char* name, const glm::vec2& value) const;
    void set(const char* name, const glm::vec3& value) const;
    void set(const char* name, const glm::vec4& value) const;
    void set(const char* name, const glm::mat3& value) const;
    void set(const char* name, const glm::mat4& value) const;
    /// Arrays: element i of the uniform from values[i]. More values than elements: the rest is ignored by GL.
    void set(const char* name, std::span<const float> values) const;
    void set(const char* name, std::span<const glm::vec2> values) const;
    void set(const char* name, std::span<const glm::vec3> values) const;
    void set(const char* name, std::span<const glm::vec4> values) const;
    void set(const char* name, std::span<const glm::mat4> values) const;

    /// Every uniform that is left after linking, of both stages, built-in ones aside: a test compares them
    /// with the names that it sets.
    std::vector<ActiveUniform> active_uniforms() const;

private:
    static void destroy(GLuint program);

    Handle<&Program::destroy> program_;
    mutable std::map<std::string, GLint, std::less<>> locations_;
};

} // namespace metamer
