// The light that arrives at the pixel from each lamp: x what the material colors, y what it mirrors unfiltered, z what
// comes by way of another wall.
// Twin: src/methods/light.h.
varying vec2 v_uv;

#if LIT
varying vec3 v_position;
varying vec3 v_normal;

uniform vec4 u_lamp_place[LAMPS];   // position, w = 1; or unit direction towards the lamp, w = 0
uniform vec3 u_lamp_falloff[LAMPS]; // constant, linear, quadratic
#if MIRRORS
uniform vec3 u_eye;
uniform vec2 u_mirror; // specular, shininess
#endif
#if SURFACE == SURFACE_BOUNCE
uniform float u_bounced[LAMPS]; // light of each lamp on the other wall
#endif

#include "bump.glsl"
#include "shadow.glsl"

// A vector of unit length; short ones stay short instead of dividing by zero.
vec3 unit(vec3 v) {
    return v * inversesqrt(max(dot(v, v), LEAST_LENGTH_SQUARED));
}

// Lambert's cosine law, Blinn-Phong highlights, falloff with distance (bounded, as its square must be a number).
vec3 arriving(vec4 place, vec3 falloff, vec3 normal, vec3 towards_eye) {
    vec3 ray = place.xyz - v_position * place.w;
    float per_length = inversesqrt(max(dot(ray, ray), LEAST_LENGTH_SQUARED));
    vec3 towards_lamp = ray * per_length;
    float d = min(1.0 / per_length, MOST_DISTANCE) * place.w;
    float reach = 1.0 / max(falloff.x + d * (falloff.y + d * falloff.z), LEAST_FALLOFF);
    float cosine = max(dot(normal, towards_lamp), 0.0);
#if MIRRORS
    float highlight = pow(max(dot(normal, unit(towards_lamp + towards_eye)), 0.0), u_mirror.y);
    return vec3(cosine, cosine > 0.0 ? u_mirror.x * highlight : 0.0, 0.0) * reach;
#else
    return vec3(cosine * reach, 0.0, 0.0);
#endif
}
#endif

void arriving_light(out vec3 light[LAMPS]) {
#if LIT
    vec3 normal = surface_normal();
#if MIRRORS
    vec3 towards_eye = unit(u_eye - v_position);
#else
    vec3 towards_eye = vec3(0.0);
#endif
    for (int l = 0; l < LAMPS; l++)
        light[l] = arriving(u_lamp_place[l], u_lamp_falloff[l], normal, towards_eye);
#if SURFACE == SURFACE_BOUNCE
    // The form factor of the other wall: 1/2 at the edge between them, v_uv.x its distance in heights of that wall.
    float share = 0.5 - 0.5 * v_uv.x * inversesqrt(v_uv.x * v_uv.x + 1.0);
    for (int l = 0; l < LAMPS; l++)
        light[l].z = u_bounced[l] * share;
#endif
#if SHADOWS > 0
    for (int l = 0; l < SHADOWS; l++)
        light[l] *= visible_share(v_shadow[l], u_shadow_tile[l]);
#endif
#else
    for (int l = 0; l < LAMPS; l++)
        light[l] = vec3(1.0, 0.0, 0.0);
#endif
}
