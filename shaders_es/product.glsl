// Three numbers of the lamp times three numbers of the material: what `rgb` and `tristimulus` share.
// Twin: src/methods/product.h.
uniform vec3 u_lamp_color[LAMPS]; // in the method's space, strength in it

#if SURFACE == SURFACE_MAPS
uniform sampler2D u_key_map;       // R * 255 = key of the material
uniform sampler2D u_luminance_map; // R scales the reflectance
uniform sampler2D u_material_map;  // per key (row): the material's three numbers, 16 bits in two texels
#else
uniform vec3 u_material;
#endif
#if SURFACE == SURFACE_RAMP || SURFACE == SURFACE_RAMP_CODES
uniform vec3 u_material_end;
#endif

vec3 material() {
#if SURFACE == SURFACE_MAPS
    float row = (floor(texture2D(u_key_map, v_uv).r * 255.0 + 0.5) + 0.5) / ATLAS_SIZE;
    vec3 high = texture2D(u_material_map, vec2(0.25, row)).rgb;
    vec3 low = texture2D(u_material_map, vec2(0.75, row)).rgb;
    vec3 packed_material = (high * 256.0 + low) / 257.0;
    return (packed_material * MATERIAL_MAP_SPAN + MATERIAL_MAP_LEAST) * texture2D(u_luminance_map, v_uv).r;
#elif SURFACE == SURFACE_RAMP
    return mix(u_material, u_material_end, v_uv.x);
#elif SURFACE == SURFACE_RAMP_CODES
    return decode(mix(u_material, u_material_end, v_uv.x));
#else
    return u_material;
#endif
}

vec3 product() {
    vec2 light[LAMPS];
    arriving_light(light);
    vec3 color = material();
    vec3 total = vec3(0.0);
    for (int l = 0; l < LAMPS; l++)
        total += u_lamp_color[l] * (color * light[l].x + light[l].y);
    return total;
}
