// Method prefiltered: the product in sharpened primaries, of materials that are known under the dominant lamp.
#include "precision.glsl"
#include "light.glsl"
#include "output.glsl"
#include "product.glsl"

uniform mat3 u_rgb_from_numbers;

void main() {
    gl_FragColor = encode(u_rgb_from_numbers * bounded(product()));
}
