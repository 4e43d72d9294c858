// Method rgb: the product in the working space, what screens usually do.
#define NUMBERS_ARE_RGB 1
#include "product.glsl"
