// Method packed: the loop of spectral, four wavelengths to a texel. Twin: src/methods/packed.h.
#include "precision.glsl"
#include "light.glsl"
#include "output.glsl"
#include "rows.glsl"

uniform sampler2D u_packed;     // 16 x 256: rows 0 .. 2 x, y, z; 64 + key lamps; 128 + key materials
uniform vec2 u_lamp_row[LAMPS]; // texture coordinate of the lamp's row; strength / k'
uniform mat3 u_rgb_from_xyz;
uniform float u_rounds; // 16: loops of a few constant rounds would be unrolled and burst small GPUs

void main() {
    vec3 light[LAMPS];
    arriving_light(light);
    vec3 sum[LAMPS]; // X', Y', Z'
    for (int l = 0; l < LAMPS; l++)
        sum[l] = vec3(0.0);
#if SURFACE == SURFACE_MAPS
    float key = key_row();
    float scale = map_scale(key);
    float row = 0.5 + 0.25 * key;
#else
    float row = u_material_row.x;
    float scale = u_material_scale.x;
#endif
    for (int i = 0; i < INTERVALS; i++) {
        if (float(i) >= u_rounds)
            break;
        float s = (float(i) + 0.5) / PACKED_COLUMNS;
        vec4 x = texture2D(u_packed, vec2(s, 0.5 / PACKED_ROWS));
        vec4 y = texture2D(u_packed, vec2(s, 1.5 / PACKED_ROWS));
        vec4 z = texture2D(u_packed, vec2(s, 2.5 / PACKED_ROWS));
        vec4 reflectance = texture2D(u_packed, vec2(s, row)) * scale;
#if SURFACE != SURFACE_PLAIN && SURFACE != SURFACE_MAPS
        vec4 second = texture2D(u_packed, vec2(s, u_material_row.y)) * u_material_scale.y;
#endif
#if SURFACE == SURFACE_RAMP
        reflectance = mix(reflectance, second, v_uv.x);
#elif SURFACE == SURFACE_MEDIUM
        reflectance *= exp2(u_thickness * v_uv.x * log2(max(second, LEAST_TRANSMITTANCE)));
#endif
        for (int l = 0; l < LAMPS; l++) {
            vec4 diffuse = vec4(light[l].x);
#if SURFACE == SURFACE_BOUNCE
            diffuse += light[l].z * second;
#endif
            vec4 phi = (reflectance * diffuse + light[l].y) * texture2D(u_packed, vec2(s, u_lamp_row[l].x));
            sum[l] += vec3(dot(x, phi), dot(y, phi), dot(z, phi));
        }
    }
    vec3 xyz = vec3(0.0);
    for (int l = 0; l < LAMPS; l++)
        xyz += bounded(bounded(sum[l]) * u_lamp_row[l].y);
    gl_FragColor = encode(u_rgb_from_xyz * bounded(xyz));
}
