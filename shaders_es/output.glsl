// From light to the framebuffer: clamp, then the transfer curve (constants: src/color/transfer.h).

// Keeps what follows finite in half precision too; brighter than this is white whatever the matrix.
vec3 bounded(vec3 light) {
    return min(light, vec3(MOST_LIGHT));
}

vec3 encode(vec3 rgb) {
    rgb = clamp(rgb, 0.0, 1.0);
#if TRANSFER_SRGB
    vec3 curved = SRGB_SCALE * pow(rgb, vec3(1.0 / SRGB_GAMMA)) - SRGB_OFFSET;
    return mix(curved, SRGB_SLOPE * rgb, vec3(lessThanEqual(rgb, vec3(SRGB_LINEAR_UP_TO))));
#else
    return rgb;
#endif
}

vec3 decode(vec3 code) {
#if TRANSFER_SRGB
    vec3 curved = pow((code + SRGB_OFFSET) / SRGB_SCALE, vec3(SRGB_GAMMA));
    return mix(curved, code / SRGB_SLOPE, vec3(lessThanEqual(code, vec3(SRGB_SLOPE * SRGB_LINEAR_UP_TO))));
#else
    return code;
#endif
}
