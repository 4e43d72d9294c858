// Which rows of the atlas the loops over wavelengths read for the material and what goes with it.
#include "maps.glsl"

#if SURFACE == SURFACE_MAPS
uniform sampler2D u_material_map; // per key (row): scale of its reflectance, 16 bits in two texels
#else
uniform vec2 u_material_row;   // coordinate of the material's row; of a ramp's end, a medium or the other wall
uniform vec2 u_material_scale; // of their reflectances: value 1 stands for this
#endif
#if SURFACE == SURFACE_MEDIUM
uniform float u_thickness; // of the medium where it is thickest
#endif

#if SURFACE == SURFACE_MAPS
// The scale of the pixel's material and its luminance map.
float map_scale(float row) {
    return joined(texture2D(u_material_map, vec2(0.25, row)).rgb, texture2D(u_material_map, vec2(0.75, row)).rgb).r *
           luminance();
}
#endif
