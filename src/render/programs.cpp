#include "render/programs.h"

#include "gles/mesh_data.h"

namespace metamer {

Program build_program(const ShaderVariant& variant) {
    return {compose_shader(variant.vertex, variant.defines, shader_files()),
            compose_shader(variant.fragment, variant.defines, shader_files()), kMeshAttributes};
}

const Program& Programs::get(const Variant& variant) {
    const auto found = programs_.find(variant);
    if (found != programs_.end())
        return found->second;
    return programs_.emplace(variant, build_program(shader_variant(variant))).first->second;
}

} // namespace metamer
