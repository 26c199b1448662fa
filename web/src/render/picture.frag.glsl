#version 300 es
// The picture, premultiplied. A pixel of a shrunk picture is the mean of four reads from the next finer mipmap level.
// A single read from a level of the pixel's size is blurred, and takes a third of the time: it is used during motion.
precision highp float;

uniform sampler2D u_picture;
// The picture is darker by this fraction.
uniform float u_shade;
// A single read shows each pixel.
uniform bool u_moving;

in vec2 v_texcoord;
#ifdef RIM
in float v_level;
in vec2 v_moved;
#endif
out vec4 colour;

vec4 shaded(vec4 premultiplied) {
  return vec4((1.0 - u_shade) * premultiplied.rgb, premultiplied.a);
}

#ifdef RIM
// Image pixels.
const float STILL = 1.0 / 256.0;
const float MOVED = 1.0 / 16.0;

// The opacity of a rim: see wasm/core/src/raster/fade.rs.
float opacity() {
  float level = clamp(v_level, 0.0, 1.0);
  return level * level * (3.0 - 2.0 * level) * clamp((length(v_moved) - STILL) / (MOVED - STILL), 0.0, 1.0);
}
#endif

vec4 filtered() {
  vec2 right = dFdx(v_texcoord);
  vec2 down = dFdy(v_texcoord);
  vec2 size = vec2(textureSize(u_picture, 0));
  // The width of a pixel in texels.
  float width = max(length(right * size), length(down * size));
  if (width <= 1.0 || u_moving) {
    return textureLod(u_picture, v_texcoord, log2(max(width, 1.0)));
  }
  float level = max(log2(width) - 1.0, 0.0);
  // Gives the four reads together the variance of a box of the pixel's size.
  // The offset is 0 at width 1, and a quarter of a pixel at width 2.
  float spread = sqrt((1.0 - 1.0 / (width * width)) / 12.0);
  vec2 across = spread * right;
  vec2 along = spread * down;
  return 0.25 * (
    textureLod(u_picture, v_texcoord + across + along, level) +
    textureLod(u_picture, v_texcoord + across - along, level) +
    textureLod(u_picture, v_texcoord - across + along, level) +
    textureLod(u_picture, v_texcoord - across - along, level)
  );
}

void main() {
  colour = shaded(filtered());
#ifdef RIM
  float shown = opacity();
  if (shown == 0.0) discard;
  colour *= shown;
#endif
}
