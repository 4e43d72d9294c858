// How many bits fragment shaders really compute with.
#pragma once

#include "gles/shader_source.h"

namespace metamer {

enum class Precision { mediump, highp };

/// The greatest b in 1 .. 31 with 1 + 2^-b > 1 in a fragment shader of this precision, 0 where not even b = 1
/// holds: 23 for IEEE single, 10 for half. What glGetShaderPrecisionFormat says is not asked: drivers report
/// wishes (DESIGN.md section 5). Asking for highp where the driver has none is the caller's mistake:
/// failure("compile", ...). Draws into a framebuffer of its own and leaves it deleted, with another program
/// and viewport.
int measured_fragment_bits(Precision precision);

/// The program that it draws with.
ShaderVariant precision_probe_variant(Precision precision);

} // namespace metamer
