// The shader files of shaders_es/, built into the program.
#pragma once

#include "gles/shader_source.h"

namespace metamer {

/// All of them, by name.
ShaderFiles shader_files();

} // namespace metamer
