// Method spectral, the thesis's loop: lamp x reflectance x observer, wavelength by wavelength, over the atlas
// (equations 7.1, 7.6-7.10). Twin: src/methods/spectral.h.
#include "precision.glsl"
#include "light.glsl"
#include "output.glsl"

uniform sampler2D u_atlas;
uniform vec2 u_lamp_row[LAMPS]; // texture coordinate of the lamp's row; strength
uniform mat3 u_rgb_from_xyz;

#if SURFACE == SURFACE_MAPS
uniform sampler2D u_key_map;       // R * 255 = key of the material
uniform sampler2D u_luminance_map; // R scales the reflectance
#else
uniform vec2 u_material_row; // texture coordinate of the material's row; of the ramp's far end
#endif

void main() {
    vec2 light[LAMPS];
    arriving_light(light);
    vec4 sum[LAMPS]; // X', Y', Z', k'
    for (int l = 0; l < LAMPS; l++)
        sum[l] = vec4(0.0);
#if SURFACE == SURFACE_MAPS
    float row = (floor(texture2D(u_key_map, v_uv).r * 255.0 + 0.5) + 0.5) / ATLAS_SIZE;
    float luminance = texture2D(u_luminance_map, v_uv).r;
#else
    float row = u_material_row.x;
#endif
    for (int i = 0; i < INTERVALS; i++) {
        float s = (float(i) + 0.5) / ATLAS_SIZE;
        vec3 observer = texture2D(u_atlas, vec2(s, 0.5 / ATLAS_SIZE)).rgb;
        float reflectance = texture2D(u_atlas, vec2(s, row)).g;
#if SURFACE == SURFACE_MAPS
        reflectance *= luminance;
#elif SURFACE == SURFACE_RAMP
        reflectance = mix(reflectance, texture2D(u_atlas, vec2(s, u_material_row.y)).g, v_uv.x);
#endif
        for (int l = 0; l < LAMPS; l++) {
            float emission = texture2D(u_atlas, vec2(s, u_lamp_row[l].x)).r;
            sum[l] += vec4(observer * ((reflectance * light[l].x + light[l].y) * emission), observer.g * emission);
        }
    }
    vec3 xyz = vec3(0.0);
    for (int l = 0; l < LAMPS; l++)
        xyz += sum[l].xyz * (u_lamp_row[l].y / sum[l].w);
    gl_FragColor = vec4(encode(u_rgb_from_xyz * bounded(xyz)), 1.0);
}
