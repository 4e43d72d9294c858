// A surface of the scene; its vertices are in world space already.
attribute vec3 a_position;
attribute vec3 a_normal;
attribute vec3 a_tangent;
attribute vec2 a_uv;

uniform mat4 u_clip_from_world;

varying vec2 v_uv;
#if LIT
varying vec3 v_position;
varying vec3 v_normal;
#if SURFACE == SURFACE_MAPS
varying vec3 v_tangent;
#endif
#if SHADOWS > 0
uniform mat4 u_shadow_from_world[SHADOWS];
uniform vec4 u_depth_from_world[SHADOWS];
varying vec4 v_shadow[SHADOWS]; // clip x, y; linear depth; clip w
#endif
#endif

void main() {
    gl_Position = u_clip_from_world * vec4(a_position, 1.0);
    v_uv = a_uv;
#if LIT
    v_position = a_position;
    v_normal = a_normal;
#if SURFACE == SURFACE_MAPS
    v_tangent = a_tangent;
#endif
#if SHADOWS > 0
    // Off the surface by some texels of the map: where light grazes, a surface must not shadow itself.
    vec4 lifted = vec4(a_position + SHADOW_LIFT * a_normal, 1.0);
    for (int l = 0; l < SHADOWS; l++) {
        v_shadow[l] = u_shadow_from_world[l] * lifted;
        v_shadow[l].z = dot(u_depth_from_world[l], lifted);
    }
#endif
#endif
}
