// A picture laid on the screen: a scene that was drawn before, or words.
attribute vec3 a_position; // a unit square's corners
attribute vec2 a_uv;

uniform vec4 u_place;      // clip coordinates of the lower left corner, then width and height
uniform vec4 u_uv;         // likewise in the picture
uniform vec4 u_before_uv;  // likewise in the picture that fades out
uniform vec4 u_turn;       // columns of the matrix from the picture's clip coordinates to the surface's

varying vec2 v_uv;
#if FADING
varying vec2 v_before_uv;
#endif

void main() {
    vec2 seen = u_place.xy + a_position.xy * u_place.zw;
    gl_Position = vec4(mat2(u_turn.xy, u_turn.zw) * seen, 0.0, 1.0);
    v_uv = u_uv.xy + a_uv * u_uv.zw;
#if FADING
    v_before_uv = u_before_uv.xy + a_uv * u_before_uv.zw;
#endif
}
