// Fragment highp is optional in ES 2 (GLSL ES 1.00, section 4.5.4): take it where there is one.
#ifdef GL_FRAGMENT_PRECISION_HIGH
precision highp float;
#else
precision mediump float;
#endif
