// Three numbers of the lamp times three numbers of the material: all of `rgb`, `tristimulus` and `prefiltered`, which
// differ in what the numbers are. Twin: src/methods/product.h.
#include "precision.glsl"
#include "light.glsl"
#include "output.glsl"
#include "maps.glsl"

#ifndef NUMBERS_ARE_RGB
uniform mat3 u_rgb_from_numbers;
#endif
uniform vec3 u_lamp_color[LAMPS]; // in the method's space, strength in it

#if SURFACE == SURFACE_MAPS
uniform sampler2D u_material_map; // per key (row): the material's three numbers, 16 bits in two texels
#else
uniform vec3 u_material;
#endif
#if SURFACE == SURFACE_RAMP || SURFACE == SURFACE_RAMP_CODES
uniform vec3 u_material_end;
#elif SURFACE == SURFACE_MEDIUM
uniform vec3 u_medium_log2; // of its transmittance where it is thickest
#elif SURFACE == SURFACE_BOUNCE
uniform vec3 u_other;
#endif

vec3 material() {
#if SURFACE == SURFACE_MAPS
    float row = key_row();
    vec3 share = joined(texture2D(u_material_map, vec2(0.25, row)).rgb, texture2D(u_material_map, vec2(0.75, row)).rgb);
    return (share * MATERIAL_MAP_SPAN + MATERIAL_MAP_LEAST) * luminance();
#elif SURFACE == SURFACE_RAMP
    return mix(u_material, u_material_end, v_uv.x);
#elif SURFACE == SURFACE_RAMP_CODES
    return decode(mix(u_material, u_material_end, v_uv.x));
#elif SURFACE == SURFACE_MEDIUM
    return u_material * exp2(u_medium_log2 * v_uv.x);
#else
    return u_material;
#endif
}

vec3 product() {
    vec3 light[LAMPS];
    arriving_light(light);
    vec3 color = material();
    vec3 total = vec3(0.0);
    for (int l = 0; l < LAMPS; l++) {
        vec3 diffuse = vec3(light[l].x);
#if SURFACE == SURFACE_BOUNCE
        diffuse += u_other * light[l].z;
#endif
        total += part(u_lamp_color[l] * (color * diffuse + light[l].y));
    }
    return total;
}

void main() {
#ifdef NUMBERS_ARE_RGB
    gl_FragColor = encode(product());
#else
    gl_FragColor = encode(u_rgb_from_numbers * bounded(product()));
#endif
}
