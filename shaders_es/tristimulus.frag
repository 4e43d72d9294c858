// Method tristimulus: the product in XYZ, the thesis's metameric side.
#include "precision.glsl"
#include "light.glsl"
#include "output.glsl"
#include "product.glsl"

uniform mat3 u_rgb_from_xyz;

void main() {
    gl_FragColor = vec4(encode(u_rgb_from_xyz * bounded(product())), 1.0);
}
