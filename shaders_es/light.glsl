// The light that arrives at the pixel from each lamp: x what the material colors, y what it mirrors unfiltered.
// Twin: src/methods/light.h.
varying vec2 v_uv;

#if LIT
varying vec3 v_position;
varying vec3 v_normal;

uniform vec4 u_lamp_place[LAMPS];   // position, w = 1; or unit direction towards the lamp, w = 0
uniform vec3 u_lamp_falloff[LAMPS]; // constant, linear, quadratic
uniform vec3 u_eye;
uniform vec2 u_mirror; // specular, shininess

#include "bump.glsl"
#include "shadow.glsl"

// A vector of unit length; short ones stay short instead of dividing by zero.
vec3 unit(vec3 v) {
    return v * inversesqrt(max(dot(v, v), LEAST_LENGTH_SQUARED));
}

// Lambert's cosine law, Blinn-Phong highlights, falloff with distance.
vec2 arriving(vec4 place, vec3 falloff, float visible, vec3 normal, vec3 towards_eye) {
    vec3 ray = place.xyz - v_position * place.w;
    float d = length(ray) * place.w;
    vec3 towards_lamp = unit(ray);
    float reach = visible / max(falloff.x + d * (falloff.y + d * falloff.z), LEAST_FALLOFF);
    float cosine = max(dot(normal, towards_lamp), 0.0);
    float highlight = pow(max(dot(normal, unit(towards_lamp + towards_eye)), 0.0), u_mirror.y);
    return vec2(cosine, cosine > 0.0 ? u_mirror.x * highlight : 0.0) * reach;
}
#endif

void arriving_light(out vec2 light[LAMPS]) {
#if LIT
    vec3 normal = surface_normal();
    vec3 towards_eye = unit(u_eye - v_position);
    for (int l = 0; l < LAMPS; l++)
        light[l] = arriving(u_lamp_place[l], u_lamp_falloff[l], 1.0, normal, towards_eye);
#if SHADOWS > 0
    for (int l = 0; l < SHADOWS; l++)
        light[l] *= visible_share(v_shadow[l], u_shadow_tile[l]);
#endif
#else
    for (int l = 0; l < LAMPS; l++)
        light[l] = vec2(1.0, 0.0);
#endif
}
