// The shader files of shaders_es/, built into the program.
#pragma once

#include "gles/program.h"

namespace metamer {

/// All of them, by name.
ShaderFiles shader_files();

/// Composes, compiles and links a variant of them, attributes as meshes have them. Throws what compose_shader
/// and Program throw.
Program program_of(const ShaderVariant& variant);

} // namespace metamer
