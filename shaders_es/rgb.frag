// Method rgb: the product in the working space, what screens usually do.
#include "precision.glsl"
#include "light.glsl"
#include "output.glsl"
#include "product.glsl"

void main() {
    gl_FragColor = encode(product());
}
