// Method folded: lamp and material were summed over the wavelengths before; their color is a constant, or, where the
// pixel's key says which material, an entry of a table. Twin: src/methods/folded.h.
#include "precision.glsl"
#include "light.glsl"
#include "output.glsl"
#include "maps.glsl"

// Linear RGB of the display, strength in it.
#if SURFACE == SURFACE_MAPS
uniform sampler2D u_material_map; // per key (row) and lamp: 16 bits in two texels, over the lamp's range
uniform vec2 u_folded_range[LAMPS]; // least, span
#else
uniform vec3 u_folded[LAMPS]; // the lamp on the material
#endif
#if SURFACE == SURFACE_RAMP
uniform vec3 u_folded_end[LAMPS]; // on the material at the far end
#elif SURFACE == SURFACE_BOUNCE
uniform vec3 u_folded_bounce[LAMPS]; // on the other wall, then on the material
#endif
#if MIRRORS
uniform vec3 u_lamp_color[LAMPS]; // the lamp itself
#endif

void main() {
    vec3 light[LAMPS];
    arriving_light(light);
#if SURFACE == SURFACE_MAPS
    float row = key_row();
    float returned = luminance();
#endif
    vec3 total = vec3(0.0);
    for (int l = 0; l < LAMPS; l++) {
#if SURFACE == SURFACE_MAPS
        float s = (float(l) + 0.25) / MOST_LAMPS;
        vec3 share = joined(texture2D(u_material_map, vec2(s, row)).rgb,
                            texture2D(u_material_map, vec2(s + 0.5 / MOST_LAMPS, row)).rgb);
        vec3 color = (share * u_folded_range[l].y + u_folded_range[l].x) * returned;
#elif SURFACE == SURFACE_RAMP
        vec3 color = mix(u_folded[l], u_folded_end[l], v_uv.x);
#else
        vec3 color = u_folded[l];
#endif
        color *= light[l].x;
#if SURFACE == SURFACE_BOUNCE
        color += u_folded_bounce[l] * light[l].z;
#endif
#if MIRRORS
        color += u_lamp_color[l] * light[l].y;
#endif
        total += part(color);
    }
    gl_FragColor = encode(total);
}
