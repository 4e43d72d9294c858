// The surface's normal, tilted by the normal map where there is one.
#if SURFACE == SURFACE_MAPS
varying vec3 v_tangent;

uniform sampler2D u_normal_map; // tangent-space normal, 128/255 is 0
#endif

vec3 surface_normal() {
#if SMOOTH
    vec3 normal = normalize(v_normal);
#else
    vec3 normal = v_normal; // a plane's, of length 1 everywhere
#endif
#if SURFACE == SURFACE_MAPS
    vec3 tilt = (texture2D(u_normal_map, v_uv).xyz * 255.0 - 128.0) / 127.0;
    vec3 tangent = normalize(v_tangent - normal * dot(normal, v_tangent));
    vec3 bitangent = cross(normal, tangent);
    normal = normalize(tangent * tilt.x + bitangent * tilt.y + normal * tilt.z);
#endif
    return normal;
}
