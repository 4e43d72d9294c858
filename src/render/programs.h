// Programs by variant, built when first asked for.
#pragma once

#include <map>

#include "gles/program.h"
#include "render/variants.h"

namespace metamer {

/// Composes, compiles and links one variant, and sees that it draws. Throws failure where the GPU does not.
Program build_program(const ShaderVariant& variant);

/// Needs a context; each variant is built once.
class Programs {
public:
    const Program& get(const Variant& variant);

private:
    std::map<Variant, Program> programs_;
};

} // namespace metamer
