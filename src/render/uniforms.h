// Uniform values as plain data: computed without GL, set when drawn.
#pragma once

#include <algorithm>
#include <array>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <variant>
#include <vector>

#include "color/matrix3.h"
#include "gles/program.h"

namespace metamer {

using UniformValue = std::variant<int, float, glm::vec2, glm::vec3, glm::vec4, glm::mat3, std::vector<float>,
                                  std::vector<glm::vec2>, std::vector<glm::vec3>, std::vector<glm::vec4>,
                                  std::vector<glm::mat4>>;

struct Uniform {
    const char* name;
    UniformValue value;
};
using Uniforms = std::vector<Uniform>;

/// Sets them in the program that is current.
inline void set_uniforms(const Program& program, const Uniforms& uniforms) {
    for (const Uniform& uniform : uniforms)
        std::visit([&](const auto& value) { program.set(uniform.name, value); }, uniform.value);
}

/// Light as half precision can hold it: what is brighter is white, and infinities breed NaN.
inline float finite_in_half(double light) {
    constexpr double kMost = 65504;
    return static_cast<float>(std::clamp(light, -kMost, kMost));
}

inline glm::vec3 to_glm(const std::array<double, 3>& v) {
    return {finite_in_half(v[0]), finite_in_half(v[1]), finite_in_half(v[2])};
}

glm::mat3 to_glm(const Matrix3& a);

} // namespace metamer
