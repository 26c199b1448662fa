#version 300 es
// One pixel of the picture, premultiplied: the one that wasm/core/src/raster/kernel.rs takes as the nearest.
// It replaces the colour below it, unless it is empty.
precision highp float;

uniform sampler2D u_picture;
// The picture is darker by this fraction.
uniform float u_shade;

in vec2 v_texcoord;
out vec4 colour;

// Positions are rounded to this fraction of a pixel.
const float FRACTIONS = 256.0;

void main() {
  ivec2 size = textureSize(u_picture, 0);
  vec2 steps = floor(v_texcoord * vec2(size) * FRACTIONS + 0.5);
  colour = texelFetch(u_picture, clamp(ivec2(floor(steps / FRACTIONS)), ivec2(0), size - 1), 0);
  if (colour.a == 0.0) discard;
  colour.rgb *= 1.0 - u_shade;
}
