// Method tristimulus: the product in XYZ, the thesis's metameric side.
#include "product.glsl"
