#include "gles/precision_probe.h"

#include <cmath>
#include <string>

#include "gles/check.h"
#include "gles/framebuffer.h"
#include "gles/mesh.h"
#include "gles/program.h"

namespace metamer {

namespace {

constexpr int kMostBits = 31;

constexpr std::string_view kVertex = R"(attribute vec3 a_position;
attribute vec2 a_uv;
varying float v_zero;
void main() {
    v_zero = a_uv.x;
    gl_Position = vec4(a_position, 1.0);
}
)";

// v_zero is 0 at every vertex, which no compiler can know: arithmetic on uniforms alone may be done ahead of
// the draw, by the CPU, at another precision. fract() does not let `one + e > one` be simplified to `e > 0`.
constexpr std::string_view kFragment = R"(precision FLOAT float;
varying float v_zero;
uniform float u_one;
uniform float u_e;
void main() {
    float sum = (u_one + v_zero) + u_e;
    gl_FragColor = vec4(fract(sum) > 0.0 ? 1.0 : 0.0);
}
)";

Program probe(Precision precision) {
    const ShaderFiles files = [](std::string_view name) {
        return name == "precision_probe.vert" ? kVertex : kFragment;
    };
    return {compose_shader("precision_probe.vert", {}, files),
            compose_shader("precision_probe.frag",
                           {{"FLOAT", precision == Precision::highp ? "highp" : "mediump"}}, files),
            kMeshAttributes};
}

/// One triangle over the whole viewport, all else 0.
MeshData cover() {
    MeshData data;
    for (const auto& [x, y] : {std::pair(-1.0F, -1.0F), std::pair(3.0F, -1.0F), std::pair(-1.0F, 3.0F)}) {
        data.vertices.insert(data.vertices.end(), {x, y});
        data.vertices.insert(data.vertices.end(), kVertexFloats - 2, 0.0F);
    }
    data.indices = {0, 1, 2};
    return data;
}

} // namespace

int measured_fragment_bits(Precision precision) {
    const Framebuffer results(kMostBits, 1);
    const Program program = probe(precision);
    const Mesh mesh(cover());
    program.set("u_one", 1.0F);
    for (int bits = 1; bits <= kMostBits; ++bits) {
        glViewport(bits - 1, 0, 1, 1);
        program.set("u_e", std::ldexp(1.0F, -bits));
        mesh.draw();
    }
    throw_on_gl_error("draw", "the precision probe");
    const std::vector<std::uint8_t> rgba = results.read_rgba();
    int bits = 0;
    while (bits < kMostBits && rgba[static_cast<std::size_t>(bits) * 4] > 127)
        ++bits;
    return bits;
}

} // namespace metamer
