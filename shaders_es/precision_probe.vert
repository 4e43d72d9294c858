// One triangle over one pixel for each number of bits (gles/precision_probe.h).
attribute vec3 a_position;
attribute vec2 a_uv;
varying float v_zero;

void main() {
    v_zero = a_uv.x;
    gl_Position = vec4(a_position, 1.0);
}
