// A picture laid on the screen, premultiplied by its alpha; or two, one fading into the other.
#include "precision.glsl"

varying vec2 v_uv;

uniform sampler2D u_picture;
uniform float u_share; // how much of it is there already, 0 .. 1
#if FADING
varying vec2 v_before_uv;

uniform sampler2D u_before;
#endif

void main() {
    vec4 now = texture2D(u_picture, v_uv);
#if FADING
    gl_FragColor = mix(texture2D(u_before, v_before_uv), now, u_share);
#else
    gl_FragColor = now * u_share;
#endif
}
