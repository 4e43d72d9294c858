// White where 1 + e is above 1 in arithmetic of FLOAT (highp or mediump), black where e is lost.
precision FLOAT float;

varying float v_zero; // 0 at every vertex, which no compiler can know: it may compute what uniforms alone say
                      // ahead of the draw, at another precision
uniform float u_one;
uniform float u_e;

void main() {
    float sum = (u_one + v_zero) + u_e;
    gl_FragColor = vec4(fract(sum) > 0.0 ? 1.0 : 0.0); // `sum > u_one` could be simplified to `u_e > 0.0`
}
