#version 300 es
// The point of the picture that is drawn at each pixel, where it is more than half opaque. Coordinates go from 1 to
// 65535 across the picture, and 0 is nothing. With `u_below`, the point of another part below the one in `u_top`.
precision highp float;
precision highp usampler2D;

uniform sampler2D u_picture;
uniform vec2 u_picture_size;
uniform bool u_below;
uniform usampler2D u_top;
// Points farther apart than this belong to different parts, image pixels.
uniform float u_apart;

in vec2 v_texcoord;
out uvec2 place;

const float STEPS = 65534.0;

void main() {
  if (texture(u_picture, v_texcoord).a < 0.5) discard;
  if (u_below) {
    vec2 top = (vec2(texelFetch(u_top, ivec2(gl_FragCoord.xy), 0).rg) - 1.0) / STEPS;
    if (distance(top * u_picture_size, v_texcoord * u_picture_size) < u_apart) discard;
  }
  place = uvec2(clamp(v_texcoord, 0.0, 1.0) * STEPS + 1.5);
}
