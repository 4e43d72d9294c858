#include "render/uniforms.h"

namespace metamer {

glm::mat3 to_glm(const Matrix3& a) {
    glm::mat3 out;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column) // glm counts columns first
            out[column][row] =
                static_cast<float>(a.m[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)]);
    return out;
}

} // namespace metamer
