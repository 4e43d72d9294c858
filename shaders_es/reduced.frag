// Method reduced: a few wavelengths, chosen and weighted for the scene's lamps, for what is not linear in a pixel.
// Twin: src/methods/reduced.h.
#include "precision.glsl"
#include "light.glsl"
#include "output.glsl"
#include "maps.glsl"

// A tap: rgb weight of the lamp there (linear RGB of the display; strength and a plain material's reflectance in it);
// w log2 of a medium's transmittance where it is thickest, or the other wall's reflectance.
#if TAPS > 0
uniform vec4 u_tap[TAPS]; // of one lamp, where ES 2's floor of uniforms has room
#else
uniform sampler2D u_tap_table;        // 32 x 32: column = tap; rows 2 l, 2 l + 1: high and low byte of lamp l's weight
uniform vec4 u_tap_range[LAMPS];      // least and span of its rgb; of w (rows 16, 17)
uniform float u_taps;                 // how many; bound like this the loop is not unrolled
#endif
#if SURFACE == SURFACE_MAPS || SURFACE == SURFACE_RAMP
uniform sampler2D u_material_map; // 32 x 64: column = tap, row = key: reflectance, 16 bits in R and G
#endif
#if SURFACE == SURFACE_RAMP
uniform vec2 u_material_row; // coordinate of the row of either end
#endif
#if MIRRORS
uniform vec3 u_lamp_color[LAMPS];
#endif

#if SURFACE == SURFACE_MAPS || SURFACE == SURFACE_RAMP
float reflectance_at(float s, float row) {
    vec2 code = texture2D(u_material_map, vec2(s, row)).rg;
    return (code.r * 256.0 + code.g) / 257.0;
}
#endif

#if TAPS == 0
vec4 table_at(float s, float row) {
    vec4 high = texture2D(u_tap_table, vec2(s, (row + 0.5) / TAP_TABLE_SIZE));
    vec4 low = texture2D(u_tap_table, vec2(s, (row + 1.5) / TAP_TABLE_SIZE));
    return (high * 256.0 + low) / 257.0;
}
#endif

void main() {
    vec3 light[LAMPS];
    arriving_light(light);
#if SURFACE == SURFACE_MAPS
    float row = key_row();
    float returned = luminance();
#endif
    vec3 total = vec3(0.0);
#if TAPS > 0
    for (int i = 0; i < TAPS; i++) {
        vec4 tap = u_tap[i];
        float w = tap.w;
#else
    for (int i = 0; i < INTERVALS; i++) {
        if (float(i) >= u_taps)
            break;
        float w = 0.0;
#endif
        float s = (float(i) + 0.5) / TAP_TABLE_SIZE;
#if TAPS == 0 && (SURFACE == SURFACE_MEDIUM || SURFACE == SURFACE_BOUNCE)
        w = table_at(s, 16.0).r * u_tap_range[0].w + u_tap_range[0].z;
#endif
        float passed = 1.0;
#if SURFACE == SURFACE_MEDIUM
        passed = exp2(w * v_uv.x);
#elif SURFACE == SURFACE_MAPS
        passed = reflectance_at(s, row) * returned;
#elif SURFACE == SURFACE_RAMP
        passed = mix(reflectance_at(s, u_material_row.x), reflectance_at(s, u_material_row.y), v_uv.x);
#endif
        for (int l = 0; l < LAMPS; l++) {
            float diffuse = light[l].x;
#if SURFACE == SURFACE_BOUNCE
            diffuse += w * light[l].z;
#endif
#if TAPS > 0
            vec3 weight = tap.rgb;
#else
            vec3 weight = table_at(s, 2.0 * float(l)).rgb * u_tap_range[l].y + u_tap_range[l].x;
#endif
            total += bounded(weight * (passed * diffuse));
        }
    }
#if MIRRORS
    for (int l = 0; l < LAMPS; l++)
        total += bounded(u_lamp_color[l] * light[l].y);
#endif
    gl_FragColor = encode(bounded(total));
}
