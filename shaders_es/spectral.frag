// Method spectral, the thesis's loop: lamp x reflectance x observer, wavelength by wavelength, over the atlas
// (equations 7.1, 7.6-7.10). Twin: src/methods/spectral.h.
#include "precision.glsl"
#include "light.glsl"
#include "output.glsl"
#include "rows.glsl"

uniform sampler2D u_atlas;
uniform vec2 u_lamp_row[LAMPS]; // texture coordinate of the lamp's row; strength
uniform mat3 u_rgb_from_xyz;

void main() {
    vec3 light[LAMPS];
    arriving_light(light);
    vec4 sum[LAMPS]; // X', Y', Z', k'
    for (int l = 0; l < LAMPS; l++)
        sum[l] = vec4(0.0);
#if SURFACE == SURFACE_MAPS
    float row = key_row();
    float scale = map_scale(row);
#else
    float row = u_material_row.x;
    float scale = u_material_scale.x;
#endif
    for (int i = 0; i < INTERVALS; i++) {
        float s = (float(i) + 0.5) / ATLAS_SIZE;
        vec3 observer = texture2D(u_atlas, vec2(s, 0.5 / ATLAS_SIZE)).rgb;
        float reflectance = texture2D(u_atlas, vec2(s, row)).g * scale;
#if SURFACE != SURFACE_PLAIN && SURFACE != SURFACE_MAPS
        float second = texture2D(u_atlas, vec2(s, u_material_row.y)).g * u_material_scale.y;
#endif
#if SURFACE == SURFACE_RAMP
        reflectance = mix(reflectance, second, v_uv.x);
#elif SURFACE == SURFACE_MEDIUM
        reflectance *= exp2(u_thickness * v_uv.x * log2(max(second, LEAST_TRANSMITTANCE)));
#endif
        for (int l = 0; l < LAMPS; l++) {
            float diffuse = light[l].x;
#if SURFACE == SURFACE_BOUNCE
            diffuse += light[l].z * second;
#endif
            float emission = texture2D(u_atlas, vec2(s, u_lamp_row[l].x)).r;
            sum[l] += vec4(observer * ((reflectance * diffuse + light[l].y) * emission), observer.g * emission);
        }
    }
    vec3 xyz = vec3(0.0);
    for (int l = 0; l < LAMPS; l++)
        xyz += bounded(bounded(sum[l].xyz / max(sum[l].w, LEAST_K)) * u_lamp_row[l].y);
    gl_FragColor = encode(u_rgb_from_xyz * bounded(xyz));
}
