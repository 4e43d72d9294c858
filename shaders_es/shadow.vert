// The scene as a lamp sees it.
attribute vec3 a_position;

uniform mat4 u_shadow_from_world;

varying vec2 v_depth; // clip z, w

void main() {
    gl_Position = u_shadow_from_world * vec4(a_position, 1.0);
    v_depth = gl_Position.zw;
}
