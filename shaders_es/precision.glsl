// Fragment highp is optional in ES 2 (GLSL ES 1.00, section 4.5.4): take it where there is one. Samplers are lowp unless
// told otherwise (section 4.5.3), and a driver may then hand out 255ths rounded to half precision: too little for the
// high byte of a number of 16 bits.
#ifdef GL_FRAGMENT_PRECISION_HIGH
precision highp float;
precision highp sampler2D;
#else
precision mediump float;
precision mediump sampler2D;
#endif
