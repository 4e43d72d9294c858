// Method prefiltered: the product in sharpened primaries, of materials that are known under the dominant lamp.
#include "product.glsl"
