#version 300 es
// Where a vertex goes: eq. 1 of the paper, p' = Σ w_i(p) T_i(p), over the sites that reach the vertex.
// A motion T_i is kept about its site's own rest place: T_i(p) = posed_i + [a c; b d] (p − rest_i).
precision highp float;
precision highp int;
precision highp sampler2D;

// Per entry: (site, weight).
uniform sampler2D u_weights;
// Three texels per site: (a, b, c, d), (rest, posed), (depth, angle, 0, 0).
uniform sampler2D u_motions;
uniform vec2 u_picture_size;
uniform vec2 u_canvas_size;
// Device pixels: (scale, x, y) of the view.
uniform vec3 u_view;
uniform bool u_at_rest;

in vec2 a_rest;
// First entry and number of entries.
in uvec2 a_row;

out vec2 v_texcoord;

vec4 record(sampler2D data, int index) {
  int width = textureSize(data, 0).x;
  return texelFetch(data, ivec2(index % width, index / width), 0);
}

vec2 moved(int site, vec2 p) {
  vec4 linear = record(u_motions, 3 * site);
  vec4 places = record(u_motions, 3 * site + 1);
  return places.zw + mat2(linear) * (p - places.xy);
}

vec2 blended(vec2 p) {
  int first = int(a_row.x);
  int count = int(a_row.y);
  if (u_at_rest || count == 0) return p;
  vec2 sum = vec2(0.0);
  for (int entry = first; entry < first + count; entry++) {
    vec2 site_weight = record(u_weights, entry).xy;
    sum += site_weight.y * moved(int(site_weight.x), p);
  }
  return sum;
}

void main() {
  v_texcoord = a_rest / u_picture_size;
  vec2 device = blended(a_rest) * u_view.x + u_view.yz;
  gl_Position = vec4((device / u_canvas_size * 2.0 - 1.0) * vec2(1.0, -1.0), 0.0, 1.0);
}
