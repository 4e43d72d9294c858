// Fragment shaders that watch themselves: the program that a frame is drawn with, its text changed so that a
// pixel is white only where every value that it clamped, bounded or wrote was a number.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "gles/mesh_data.h"
#include "gles/program.h"
#include "gles/shader_files.h"
#include "render/variants.h"

namespace metamer {

/// Text put in the place of other text, everywhere.
struct Edit {
    std::string from, to;
};

/// How a fragment shader differs from the shipped one.
struct FragmentEdits {
    bool mediump = false; ///< as a GPU without fragment highp sees it
    bool watched = false;
    std::vector<Edit> others;
    auto key() const {
        std::string all = std::string(mediump ? "m" : "h") + (watched ? "w" : "p");
        for (const Edit& edit : others)
            all += '\n' + edit.from + '\n' + edit.to;
        return all;
    }
};

/// Comparisons with two uniforms that are 0: no compiler can fold away whether x is a number. clamp(), max()
/// and min() may turn what is none into a number (GLSL ES 1.00 leaves it open), so they look at it first.
inline constexpr std::string_view kWatch = R"(uniform float u_zero, u_nought;
float all_numbers = 1.0;
float seen(float x) { all_numbers *= x < u_zero || x >= u_nought ? 1.0 : 0.0; return x; }
vec2 seen(vec2 v) { return vec2(seen(v.x), seen(v.y)); }
vec3 seen(vec3 v) { return vec3(seen(v.x), seen(v.y), seen(v.z)); }
vec4 seen(vec4 v) { return vec4(seen(v.x), seen(v.y), seen(v.z), seen(v.w)); }
#define clamp(x, a, b) clamp(seen(x), a, b)
#define max(a, b) max(seen(a), seen(b))
#define min(a, b) min(seen(a), seen(b))
#define exp2(x) exp2(seen(x))
)";

/// Throws logic_error where the shader no longer says `from`: a test that changes nothing shows nothing.
inline void replace(std::string& text, const std::string& from, const std::string& to) {
    std::size_t at = text.find(from);
    if (at == std::string::npos)
        throw std::logic_error("no text to replace: " + from);
    for (; at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
}

inline Program edited_program(const Variant& variant, const FragmentEdits& edits) {
    const ShaderVariant files = shader_variant(variant);
    ComposedShader fragment = compose_shader(files.fragment, files.defines, shader_files());
    for (const Edit& edit : edits.others)
        replace(fragment.text, edit.from, edit.to);
    if (edits.watched) {
        const std::string chosen = "precision mediump sampler2D;\n#endif\n";
        replace(fragment.text, chosen, chosen + std::string(kWatch));
        replace(fragment.text, "return vec4(code, 1.0);", "seen(code); return vec4(vec3(all_numbers), 1.0);");
    }
    if (edits.mediump)
        replace(fragment.text, "GL_FRAGMENT_PRECISION_HIGH", "METAMER_NO_SUCH_PRECISION");
    // A driver's log would name lines that are none of the shipped file's.
    fragment.lines.clear();
    return {compose_shader(files.vertex, files.defines, shader_files()), fragment, kMeshAttributes};
}

} // namespace metamer
