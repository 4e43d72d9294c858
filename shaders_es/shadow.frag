// Depth 0 .. 1 in two channels of 8 bits: ES 2 has no depth textures in its core.
#include "precision.glsl"

varying float v_depth;

void main() {
    float depth = clamp(v_depth, 0.0, 1.0);
    float coarse = floor(depth * 255.0) / 255.0;
    gl_FragColor = vec4(coarse, (depth - coarse) * 255.0, 0.0, 1.0);
}
