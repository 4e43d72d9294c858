#include "gles/precision_probe.h"

#include <cmath>
#include <string>

#include "gles/check.h"
#include "gles/framebuffer.h"
#include "gles/mesh.h"
#include "gles/shader_files.h"

namespace metamer {

namespace {

constexpr int kMostBits = 31;

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

ShaderVariant precision_probe_variant(Precision precision) {
    const std::string name = precision == Precision::highp ? "highp" : "mediump";
    return {"precision_probe-" + name, "precision_probe.vert", "precision_probe.frag", {{"FLOAT", name}}};
}

int measured_fragment_bits(Precision precision) {
    const Framebuffer results(kMostBits, 1);
    const Program program = program_of(precision_probe_variant(precision));
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
