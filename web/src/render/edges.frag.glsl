#version 300 es
// A thin dark edge on the part behind another one: see wasm/core/src/raster/edges.rs, which draws the same for exports.
precision highp float;
precision highp usampler2D;

uniform usampler2D u_top;
uniform usampler2D u_below;
uniform vec2 u_picture_size;
// Device pixels per image pixel.
uniform float u_scale;
// Of the disc, image pixels.
uniform float u_radius;

out vec4 colour;

const int PLACES = 32;
const float HALF_PI = 1.5707963267948966;
const float GOLDEN_ANGLE = 2.399963229728653;
const float DARKNESS = 0.9;
const float APART = 4.0;
const float STRETCH = 3.0;
const float STEPS = 65534.0;

// Image pixels.
vec2 rest(uvec2 place) {
  return (vec2(place) - 1.0) / STEPS * u_picture_size;
}

// The darkness at this pixel of the part that has the point `own` here, where it is seen or covered.
float darkness(vec2 own, bool is_seen) {
  float seen = 0.0;
  float covered = 0.0;
  float distinct = 0.0;
  for (int k = 0; k < PLACES; k++) {
    float away = u_radius * u_scale * sqrt((float(k) + 0.5) / float(PLACES));
    float angle = GOLDEN_ANGLE * float(k);
    ivec2 there = ivec2(floor(gl_FragCoord.xy + away * vec2(cos(angle), sin(angle))));
    if (any(lessThan(there, ivec2(0))) || any(greaterThanEqual(there, textureSize(u_top, 0)))) continue;
    uvec2 top = texelFetch(u_top, there, 0).rg;
    uvec2 below = texelFetch(u_below, there, 0).rg;
    float within = STRETCH * (away + 1.0) / u_scale;
    float apart = distance(rest(top), own);
    if (top.x != 0u && apart < within) seen += 1.0;
    if (below.x == 0u || distance(rest(below), own) > within) continue;
    covered += 1.0;
    distinct += clamp(apart / (APART * u_radius) - 1.0, 0.0, 1.0);
  }
  // The border cuts off a disc at a distance of (π/2) (½ − covered) radii from its middle.
  float half_of_all = 0.5 * float(PLACES);
  float clear = is_seen ? half_of_all - covered : min(half_of_all - covered, seen - half_of_all);
  float border = HALF_PI * clear / float(PLACES) * u_radius * u_scale;
  return DARKNESS * clamp(border + 0.5, 0.0, 1.0) * distinct / float(PLACES);
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  uvec2 top = texelFetch(u_top, pixel, 0).rg;
  uvec2 below = texelFetch(u_below, pixel, 0).rg;
  float dark = top.x == 0u ? 0.0 : darkness(rest(top), true);
  // A pixel in front shows some of the part behind if the border runs through it.
  if (below.x != 0u) dark = max(dark, darkness(rest(below), false));
  if (dark == 0.0) discard;
  colour = vec4(0.0, 0.0, 0.0, dark);
}
