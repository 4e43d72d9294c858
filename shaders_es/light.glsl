// The light that arrives at the pixel from each lamp: x what the material colors, y what it mirrors unfiltered, z what
// comes by way of another wall.
// Twin: src/methods/light.h.
varying vec2 v_uv;

#if LIT
varying vec3 v_position;
varying vec3 v_normal;

uniform vec4 u_lamp_place[LAMPS]; // position, w = 1; or unit direction towards the lamp, w = 0
#if PLACED
uniform vec3 u_lamp_falloff[LAMPS]; // constant, linear, quadratic
#endif
#if SURFACE == SURFACE_BOUNCE
uniform float u_bounced[LAMPS]; // light of each lamp on the other wall
#endif
#if MIRRORS
uniform vec3 u_eye;
uniform vec2 u_mirror; // specular, half of the shininess
#endif

#include "bump.glsl"
#include "shadow.glsl"

// Lambert's cosine law, Blinn-Phong highlights, falloff with distance; written so that a lamp costs one root and one
// division, a highlight one division more; lamps without a place cost neither. Lamps stand within 100 units: squares
// stay numbers in half precision. `towards_eye`, of unit length, and its cosine with the normal are the pixel's.
vec3 arriving(vec4 place, vec3 falloff, vec3 normal, vec3 towards_eye, float eye_cosine) {
#if PLACED
    vec3 ray = place.xyz - v_position * place.w;
    float square = max(dot(ray, ray), LEAST_LENGTH_SQUARED);
    float d = sqrt(square);
    float fading = max(falloff.x + d * falloff.y + square * falloff.z, LEAST_FALLOFF);
    float share = 1.0 / (d * fading); // of the ray's components in the light
    float per_d = share > 0.0 ? share * fading : 0.0; // where infinite fading leaves nothing
    float reach = share * d;
#else
    vec3 ray = place.xyz;
    const float share = 1.0, per_d = 1.0, reach = 1.0;
#endif
    float along = dot(normal, ray);
    vec3 light = vec3(max(along, 0.0) * share, 0.0, 0.0);
#if MIRRORS
    // The cosine with the half-way vector, squared: (n . (l + e))^2 / |l + e|^2, where |l + e|^2 = 2 + 2 l . e.
    float towards = max(along * per_d + eye_cosine, 0.0);
    float squared = towards * towards / max(2.0 + 2.0 * dot(ray, towards_eye) * per_d, LEAST_LENGTH_SQUARED);
    light.y = along > 0.0 ? u_mirror.x * pow(squared, u_mirror.y) * reach : 0.0;
#endif
    return light;
}
#endif

void arriving_light(out vec3 light[LAMPS]) {
#if LIT
    vec3 normal = surface_normal();
    vec3 towards_eye = vec3(0.0);
    float eye_cosine = 0.0;
#if MIRRORS
    towards_eye = normalize(u_eye - v_position);
    eye_cosine = dot(normal, towards_eye);
#endif
    for (int l = 0; l < LAMPS; l++)
#if PLACED
        light[l] = arriving(u_lamp_place[l], u_lamp_falloff[l], normal, towards_eye, eye_cosine);
#else
        light[l] = arriving(u_lamp_place[l], vec3(0.0), normal, towards_eye, eye_cosine);
#endif
#if SURFACE == SURFACE_BOUNCE
    // The form factor of the other wall: 1/2 at the edge between them, v_uv.x its distance in heights of that wall.
    float bounce = 0.5 - 0.5 * v_uv.x * inversesqrt(v_uv.x * v_uv.x + 1.0);
    for (int l = 0; l < LAMPS; l++)
        light[l].z = u_bounced[l] * bounce;
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
