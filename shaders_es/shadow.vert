// The scene as a lamp sees it.
attribute vec3 a_position;

uniform mat4 u_shadow_from_world;
uniform vec4 u_depth_from_world; // depth along the lamp's axis, linear: perspective would crowd it at the far end

varying float v_depth;

void main() {
    vec4 position = vec4(a_position, 1.0);
    gl_Position = u_shadow_from_world * position;
    v_depth = dot(u_depth_from_world, position);
}
