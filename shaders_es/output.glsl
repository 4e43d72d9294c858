// From light to the framebuffer: what the space does not hold, the transfer curve (constants: src/color/transfer.h),
// dithering.
#if DITHER
uniform sampler2D u_dither_map; // 8 x 8 thresholds
uniform vec3 u_dither_step;     // of the framebuffer's code values
#endif

// Keeps what follows finite in half precision too; brighter than this is white whatever the matrix.
vec3 bounded(vec3 light) {
    return clamp(light, -MOST_LIGHT, MOST_LIGHT);
}

// One lamp's part of a sum: an infinite part must not meet another of the other sign. One lamp alone meets none, and
// encode() clamps.
vec3 part(vec3 light) {
#if LAMPS > 1
    return bounded(light);
#else
    return light;
#endif
}

// Colors outside the space come in towards the gray of their light, down to white as one. Twin: src/color/gamut.h.
vec3 kept_hue(vec3 c) {
    float gray = max((c.r + c.g + c.b) / 3.0, 0.0);
    float least = min(min(c.r, c.g), min(c.b, 0.0));
    float most = max(max(c.r, c.g), max(c.b, 1.0));
    float t = gray > 0.0 ? gray / (gray - least) : 0.0;
    return (gray + t * (c - gray)) / max(gray + t * (most - gray), 1.0);
}

vec3 curved(vec3 rgb) {
#if TRANSFER == TRANSFER_SRGB
    vec3 s = sqrt(rgb);
    vec3 root = (((SRGB_ROOT_4 * s + SRGB_ROOT_3) * s + SRGB_ROOT_2) * s + SRGB_ROOT_1) * s + SRGB_ROOT_0;
    return max(root, min(SRGB_SLOPE * rgb, vec3(SRGB_LINE_UP_TO)));
#elif TRANSFER == TRANSFER_SRGB_POW
    vec3 power = SRGB_SCALE * pow(rgb, vec3(1.0 / SRGB_GAMMA)) - SRGB_OFFSET;
    return mix(power, SRGB_SLOPE * rgb, vec3(lessThanEqual(rgb, vec3(SRGB_LINEAR_UP_TO))));
#else
    return rgb;
#endif
}

vec4 encode(vec3 rgb) {
#if KEEP_HUE
    rgb = kept_hue(bounded(rgb));
#endif
    vec3 code = curved(clamp(rgb, 0.0, 1.0));
#if DITHER
    code += (texture2D(u_dither_map, fract(gl_FragCoord.xy / 8.0)).r - 0.5) * u_dither_step;
#endif
    return vec4(code, 1.0);
}

vec3 decode(vec3 code) {
#if TRANSFER == TRANSFER_NONE
    return code;
#else
    vec3 power = pow((code + SRGB_OFFSET) / SRGB_SCALE, vec3(SRGB_GAMMA));
    return mix(power, code / SRGB_SLOPE, vec3(lessThanEqual(code, vec3(SRGB_LINE_UP_TO))));
#endif
}
