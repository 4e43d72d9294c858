// Method tristimulus: the product in XYZ, the thesis's metameric side.
#include "precision.glsl"
#include "light.glsl"
#include "output.glsl"
#include "product.glsl"

uniform mat3 u_rgb_from_numbers;

void main() {
    gl_FragColor = encode(u_rgb_from_numbers * bounded(product()));
}
