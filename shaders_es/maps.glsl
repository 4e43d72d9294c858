// Surfaces that carry maps: which material, and how much light it returns.
#if SURFACE == SURFACE_MAPS
uniform sampler2D u_key_map;       // R * 255 = key of the material
uniform sampler2D u_luminance_map; // R scales the reflectance

float key_row() {
    return (floor(texture2D(u_key_map, v_uv).r * 255.0 + 0.5) + 0.5) / ATLAS_SIZE;
}

float luminance() {
    return texture2D(u_luminance_map, v_uv).r;
}
#endif

// 16 bits in two texels.
vec3 joined(vec3 high, vec3 low) {
    return (high * 256.0 + low) / 257.0;
}
