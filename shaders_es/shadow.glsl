// How much of a lamp a pixel sees: 0 in its shadow, 1 in its light. Depths are packed in two channels of RGBA8 by
// shadow.frag; the tiles of up to four lamps share one texture.
#if SHADOWS > 0
varying vec4 v_shadow[SHADOWS];

uniform sampler2D u_shadow_map;
uniform vec2 u_shadow_tile[SHADOWS]; // corner s, t

float depth_at(vec2 st) {
    vec2 packed_depth = texture2D(u_shadow_map, st).rg;
    return packed_depth.x + packed_depth.y / 255.0;
}

// Percentage-closer filtering over four texels, weighted bilinearly (Reeves, Salesin, Cook 1987).
float visible_share(vec4 shadow, vec2 tile) {
    vec3 p = vec3(shadow.xy / shadow.w * 0.5 + 0.5, shadow.z);
    vec2 inside = clamp(p.xy, 2.0 / SHADOW_TILE_PX, 1.0 - 2.0 / SHADOW_TILE_PX) * SHADOW_TILE_PX - 0.5;
    vec2 corner = floor(inside);
    vec2 t = inside - corner;
    vec2 st = tile + (corner + 0.5) * (0.5 / SHADOW_TILE_PX);
    float step_st = 0.5 / SHADOW_TILE_PX;
    float depth = p.z - SHADOW_BIAS;
    vec4 lit = step(vec4(depth), vec4(depth_at(st), depth_at(st + vec2(step_st, 0.0)), depth_at(st + vec2(0.0, step_st)),
                                      depth_at(st + vec2(step_st, step_st))));
    float visible = mix(mix(lit.x, lit.y, t.x), mix(lit.z, lit.w, t.x), t.y);
    // What the lamp's tile does not show stands in no shadow; w < 0 is behind the lamp.
    vec3 beyond = abs(p - 0.5);
    return max(beyond.x, max(beyond.y, beyond.z)) < 0.5 && shadow.w > 0.0 ? visible : 1.0;
}
#endif
