// Khronos's reference compiler as a second opinion: glslangValidator with the limits of ES 2
// (es2_limits.conf). A machine without it (Debian: glslang-tools) fails the tests that ask.
#pragma once

#include <string>
#include <vector>

#include "gles2/source_facts.h"

namespace metamer::test {

/// A shader for glslang to read.
struct GlslangInput {
    std::string name; ///< in messages; of letters, digits, - and _
    Stage stage;
    std::string text;
};

/// What it says against these shaders as GLSL ES 1.00: empty when all are right. Throws failure without the
/// tool.
std::string glslang_complaints(const std::vector<GlslangInput>& inputs);

/// Each text preprocessed: macros expanded, comments gone. Throws failure when the tool is missing or
/// complains.
std::vector<std::string> glslang_preprocessed(const std::vector<GlslangInput>& inputs);

} // namespace metamer::test
