#include "gles/program.h"

#include <algorithm>
#include <glm/gtc/type_ptr.hpp>

#include "base/error.h"

namespace metamer {

namespace {

struct Shader {
    static void destroy(GLuint shader) { glDeleteShader(shader); }
    Handle<&Shader::destroy> name;
};

std::string one_line(std::string log) {
    for (std::size_t at = log.find('\n'); at != std::string::npos; at = log.find('\n', at))
        log.replace(at, 1, "; ");
    return log.empty() ? "the driver does not say why" : log;
}

using GetParameter = void (*)(GLuint, GLenum, GLint*);
using GetLog = void (*)(GLuint, GLsizei, GLsizei*, GLchar*);

std::string driver_log(GLuint name, GetParameter get, GetLog get_log) {
    GLint size = 0;
    get(name, GL_INFO_LOG_LENGTH, &size);
    std::string log(static_cast<std::size_t>(std::max(size, 1)), '\0');
    GLsizei written = 0;
    get_log(name, static_cast<GLsizei>(log.size()), &written, log.data());
    log.resize(static_cast<std::size_t>(std::max(written, 0)));
    return log;
}

Shader compiled(GLenum stage, const ComposedShader& composed) {
    Shader shader{Handle<&Shader::destroy>(glCreateShader(stage))};
    const GLuint name = shader.name.get();
    if (name == 0)
        throw failure("compile", composed.file, "glCreateShader gives no shader: no current context?");
    const char* text = composed.text.data();
    const auto length = static_cast<GLint>(composed.text.size());
    glShaderSource(name, 1, &text, &length);
    glCompileShader(name);
    GLint status = GL_FALSE;
    glGetShaderiv(name, GL_COMPILE_STATUS, &status);
    if (status != GL_TRUE)
        throw failure("compile", composed.file,
                      one_line(rewrite_log(driver_log(name, glGetShaderiv, glGetShaderInfoLog), composed)));
    return shader;
}

void set_each(GLint location, std::span<const float> v, GLsizei n) {
    glUniform1fv(location, n, v.data());
}
void set_each(GLint location, std::span<const glm::vec2> v, GLsizei n) {
    glUniform2fv(location, n, &v.front().x);
}
void set_each(GLint location, std::span<const glm::vec3> v, GLsizei n) {
    glUniform3fv(location, n, &v.front().x);
}
void set_each(GLint location, std::span<const glm::vec4> v, GLsizei n) {
    glUniform4fv(location, n, &v.front().x);
}
void set_each(GLint location, std::span<const glm::mat4> v, GLsizei n) {
    glUniformMatrix4fv(location, n, GL_FALSE, glm::value_ptr(v.front()));
}

template <class T>
void set_array(GLint location, std::span<const T> values) {
    if (!values.empty())
        set_each(location, values, static_cast<GLsizei>(values.size()));
}

} // namespace

Program::Program(const ComposedShader& vertex, const ComposedShader& fragment,
                 std::span<const char* const> attributes) {
    const Shader vertex_shader = compiled(GL_VERTEX_SHADER, vertex);
    const Shader fragment_shader = compiled(GL_FRAGMENT_SHADER, fragment);
    program_ = Handle<&Program::destroy>(glCreateProgram());
    const GLuint name = program_.get();
    glAttachShader(name, vertex_shader.name.get());
    glAttachShader(name, fragment_shader.name.get());
    for (std::size_t location = 0; location < attributes.size(); ++location)
        glBindAttribLocation(name, static_cast<GLuint>(location), attributes[location]);
    glLinkProgram(name);
    GLint status = GL_FALSE;
    glGetProgramiv(name, GL_LINK_STATUS, &status);
    if (status != GL_TRUE)
        throw failure("link", vertex.file + " with " + fragment.file,
                      one_line(rewrite_log(driver_log(name, glGetProgramiv, glGetProgramInfoLog), {})));
}

void Program::destroy(GLuint program) {
    glDeleteProgram(program);
}

void Program::use() const {
    glUseProgram(program_.get());
}

GLint Program::uniform(const char* name) const {
    if (const auto found = locations_.find(name); found != locations_.end())
        return found->second;
    const GLint location = glGetUniformLocation(program_.get(), name);
    locations_.emplace(name, location);
    return location;
}

void Program::set(const char* name, int value) const {
    use();
    glUniform1i(uniform(name), value);
}

void Program::set(const char* name, float value) const {
    set(name, std::span(&value, 1));
}

void Program::set(const char* name, const glm::vec2& value) const {
    set(name, std::span(&value, 1));
}

void Program::set(const char* name, const glm::vec3& value) const {
    set(name, std::span(&value, 1));
}

void Program::set(const char* name, const glm::vec4& value) const {
    set(name, std::span(&value, 1));
}

void Program::set(const char* name, const glm::mat4& value) const {
    set(name, std::span(&value, 1));
}

void Program::set(const char* name, const glm::mat3& value) const {
    use();
    glUniformMatrix3fv(uniform(name), 1, GL_FALSE, glm::value_ptr(value));
}

void Program::set(const char* name, std::span<const float> values) const {
    use();
    set_array(uniform(name), values);
}

void Program::set(const char* name, std::span<const glm::vec2> values) const {
    use();
    set_array(uniform(name), values);
}

void Program::set(const char* name, std::span<const glm::vec3> values) const {
    use();
    set_array(uniform(name), values);
}

void Program::set(const char* name, std::span<const glm::vec4> values) const {
    use();
    set_array(uniform(name), values);
}

void Program::set(const char* name, std::span<const glm::mat4> values) const {
    use();
    set_array(uniform(name), values);
}

std::vector<ActiveUniform> Program::active_uniforms() const {
    GLint count = 0, longest = 0;
    glGetProgramiv(program_.get(), GL_ACTIVE_UNIFORMS, &count);
    glGetProgramiv(program_.get(), GL_ACTIVE_UNIFORM_MAX_LENGTH, &longest);
    std::vector<ActiveUniform> uniforms;
    for (GLint index = 0; index < count; ++index) {
        std::string name(static_cast<std::size_t>(std::max(longest, 1)), '\0');
        GLsizei length = 0;
        GLint size = 0;
        GLenum type = 0;
        glGetActiveUniform(program_.get(), static_cast<GLuint>(index), static_cast<GLsizei>(name.size()),
                           &length, &size, &type, name.data());
        name.resize(static_cast<std::size_t>(length));
        if (name.ends_with("[0]"))
            name.resize(name.size() - 3);
        if (!name.starts_with("gl_"))
            uniforms.push_back({name, type, size});
    }
    return uniforms;
}

} // namespace metamer
