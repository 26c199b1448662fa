#version 300 es
// The posed position of a vertex. The linear blend is eq. 1 of the paper: p' = Σ w_i(p) T_i(p), over the sites that
// reach the vertex. The rigid blend is that of wasm/core/src/deform/dual.rs.
// Sums are relative to p: at 6,000 px a sum of absolute positions would lose a hundredth of a pixel.
// A motion T_i is stored about the rest position of its site: T_i(p) = posed_i + [a c; b d] (p − rest_i).
precision highp float;
precision highp int;
precision highp sampler2D;

// Per entry: (site, weight).
uniform sampler2D u_weights;
// Three texels per site: (a, b, c, d), (rest, posed), (depth, angle, cosine and sine of half the angle).
uniform sampler2D u_motions;
uniform vec2 u_picture_size;
uniform vec2 u_canvas_size;
// Device pixels: (scale, x, y) of the view.
uniform vec3 u_view;
uniform bool u_at_rest;
uniform bool u_rigid;

// All programs use the same locations, so that attribute arrays can stay enabled between them.
layout(location = 0) in vec2 a_rest;
// First weight entry and number of entries.
layout(location = 1) in uvec2 a_row;
// Where the brush has moved the vertex at rest, before the sites do: p + d(p). Elsewhere it is a_rest.
layout(location = 3) in vec2 a_place;
#ifdef HEAT
layout(location = 2) in float a_heat;
out float v_heat;
#endif
#ifdef RIM
// 1 and more is opaque, 0 and less is transparent.
layout(location = 2) in float a_level;
out float v_level;
// Image pixels.
out vec2 v_moved;
#endif

out vec2 v_texcoord;

vec4 record(sampler2D data, int index) {
  int width = textureSize(data, 0).x;
  return texelFetch(data, ivec2(index % width, index / width), 0);
}

vec2 linear_blend(vec2 p) {
  vec2 sum = vec2(0.0);
  for (int entry = int(a_row.x); entry < int(a_row.x + a_row.y); entry++) {
    vec2 site_weight = record(u_weights, entry).xy;
    int site = int(site_weight.x);
    vec4 places = record(u_motions, 3 * site + 1);
    sum += site_weight.y * (places.zw - p + mat2(record(u_motions, 3 * site)) * (p - places.xy));
  }
  return p + sum;
}

// The product of two complex numbers.
vec2 product(vec2 a, vec2 b) {
  return vec2(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x);
}

vec2 conjugate(vec2 a) {
  return vec2(a.x, -a.y);
}

// The blend is rigid from this |P|² on.
const float RIGID = 0.25;

vec2 rigid_blend(vec2 p) {
  vec2 posed = vec2(0.0);
  vec2 half_turn = vec2(0.0);
  vec2 moved = vec2(0.0);
  for (int entry = int(a_row.x); entry < int(a_row.x + a_row.y); entry++) {
    vec2 site_weight = record(u_weights, entry).xy;
    int site = int(site_weight.x);
    vec4 places = record(u_motions, 3 * site + 1);
    vec2 own_half = record(u_motions, 3 * site + 2).zw;
    vec2 own_posed = places.zw - p + mat2(record(u_motions, 3 * site)) * (p - places.xy);
    posed += site_weight.y * own_posed;
    half_turn += site_weight.y * own_half;
    moved += site_weight.y * product(conjugate(own_half), own_posed);
  }
  vec2 apart = moved - product(conjugate(half_turn), posed);
  float u = dot(half_turn, half_turn) / RIGID;
  float reciprocal = (u >= 1.0 ? 1.0 / u : 3.0 - 3.0 * u + u * u) / RIGID;
  return p + posed + product(apart, half_turn * reciprocal);
}

vec2 blended(vec2 p) {
  if (a_row.y == 0u) return p;
  return u_rigid ? rigid_blend(p) : linear_blend(p);
}

void main() {
  v_texcoord = a_rest / u_picture_size;
#ifdef HEAT
  v_heat = a_heat;
#endif
  vec2 posed = u_at_rest ? a_rest : blended(a_place);
#ifdef RIM
  v_level = a_level;
  v_moved = posed - a_rest;
#endif
  vec2 device = posed * u_view.x + u_view.yz;
  gl_Position = vec4((device / u_canvas_size * 2.0 - 1.0) * vec2(1.0, -1.0), 0.0, 1.0);
}
