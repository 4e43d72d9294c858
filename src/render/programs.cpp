#include "render/programs.h"

#include <glm/mat4x4.hpp>

#include "base/error.h"
#include "gles/draw_check.h"
#include "gles/shader_files.h"

namespace metamer {

Program build_program(const ShaderVariant& variant) {
    Program program = program_of(variant);
    program.set("u_clip_from_world", glm::mat4(1));
    program.set("u_shadow_from_world", glm::mat4(1));
    program.set("u_place", glm::vec4(0, 0, 1, 1));
    program.set("u_turn", glm::vec4(1, 0, 0, 1));
    program.set("u_share", 1.0f);
    if (!draws(program))
        throw failure("draw with", std::string(kShaderFolder) + variant.fragment,
                      "the driver accepts " + variant.name +
                          " and draws nothing; it is too long for this GPU, which fewer lamps, shadows or "
                          "maps may mend");
    return program;
}

const Program& Programs::get(const Variant& variant) {
    const auto found = programs_.find(variant);
    if (found != programs_.end())
        return found->second;
    return programs_.emplace(variant, build_program(shader_variant(variant))).first->second;
}

} // namespace metamer
