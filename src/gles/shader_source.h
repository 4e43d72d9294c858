// Shader text from files: #include, #define, and a driver's log brought back to the files people wrote.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace metamer {

/// Where shader files live in the source tree; every file name in a message starts with it.
inline constexpr std::string_view kShaderFolder = "shaders_es/";

/// A line of a shader file as messages name it: `shaders_es/lamps.glsl`, 7. Lines count from 1; line 0 of the
/// file is a #define that the composer put there.
struct ShaderLine {
    std::string file;
    int line;
};

/// What the compiler is given, and where each of its lines came from.
struct ComposedShader {
    std::string text;              ///< GLSL ES 1.00, lines ended by '\n'
    std::vector<ShaderLine> lines; ///< text line i+1 came from lines[i]
    std::string file;              ///< the file asked for, with kShaderFolder in front
};

/// Macro name and value, in the order of the #define lines.
using Defines = std::vector<std::pair<std::string, std::string>>;

/// The text of a shader file by name (`lamps.glsl`, no folder); an empty view when there is no such file.
using ShaderFiles = std::function<std::string_view(std::string_view name)>;

/// One program of the shader table: file names without folder.
struct ShaderVariant {
    std::string name;
    std::string vertex, fragment;
    Defines defines; ///< for both stages
};

/// The text of `file` with each `#include "x.glsl"` replaced by that file, once per file, and `#define NAME
/// VALUE` lines after the leading comments and #version. Conditionals are not evaluated: an include inside
/// #if is expanded there, and including the same file again where that branch does not reach is refused. Also
/// refused, with file:line: cycles, missing files, a malformed #include, a #version other than 100 or not at
/// the top of the first file, a comment that does not end. Throws failure: shaders ship inside the program.
/// GLSL ES 1.00.17 sections 3.3 and 3.4: #version may follow comments only; the default is 100.
ComposedShader compose_shader(std::string_view file, const Defines& defines, const ShaderFiles& files);

/// The driver's log with lines of `composed` named by file, trailing white space and empty lines dropped,
/// lines joined by '\n'. Known forms: Mesa `0:12(3): error: ...`, ANGLE and PowerVR `ERROR: 0:12: ...`, Mali
/// `0:12: L0001: ...`, NVIDIA `0(12) : error C0000: ...`; all become `shaders_es/lamps.glsl:7: error: ...`.
/// Other lines stay as they are.
std::string rewrite_log(const std::string& driver_log, const ComposedShader& composed);

} // namespace metamer
