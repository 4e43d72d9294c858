// What the GL says of itself, and what was measured where its word cannot be trusted.
#pragma once

#include <string>
#include <vector>

namespace metamer {

/// A float type of fragment shaders.
struct FragmentPrecision {
    int range_min_log2 =
        0; ///< as reported: the smallest magnitude is 2^-range_min_log2 (GL reports this sign)
    int range_max_log2 = 0; ///< as reported: the greatest is just below 2^(range_max_log2 + 1)
    int reported_bits = 0;  ///< as reported: relative precision 2^-bits; 0: no such type
};

/// Limits by their GL names (OpenGL ES 2.0.25 tables 6.17 to 6.20).
struct GlLimits {
    int max_fragment_uniform_vectors = 0;
    int max_vertex_uniform_vectors = 0;
    int max_varying_vectors = 0;
    int max_vertex_attribs = 0;
    int max_texture_image_units = 0;
    int max_vertex_texture_image_units = 0;
    int max_combined_texture_image_units = 0;
    int max_texture_size_px = 0;
    int max_renderbuffer_size_px = 0;
    int max_viewport_width_px = 0, max_viewport_height_px = 0;
};

struct GlInfo {
    std::string vendor, renderer, version, shading_language;
    FragmentPrecision lowp, mediump, highp;
    int measured_mediump_bits = 0; ///< the greatest b with 1 + 2^-b > 1 in a fragment shader, at most 31
    int measured_highp_bits = 0;   ///< the same; 0: no highp
    GlLimits limits;
    std::vector<std::string> extensions;      ///< present
    std::vector<std::string> extensions_used; ///< used by the program (extensions.h)
};

/// GL_RENDERER of the current context.
std::string gl_renderer();

/// Asks and measures in the current context. Leaves another framebuffer binding, viewport and program behind.
/// Throws failure when the probe shader cannot be drawn.
GlInfo gl_info();

} // namespace metamer
