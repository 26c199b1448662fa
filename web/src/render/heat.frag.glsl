#version 300 es
// The picture, premultiplied, under a heat map of values from 0 to 1.
// Optional isolines lie at every tenth; the one at 0.5 is bold.
precision highp float;

uniform sampler2D u_picture;
// Colours at 0, 0.2, … 1, straight alpha.
uniform vec4 u_ramp[6];
// Width of an isoline in device pixels; 0 for no isolines.
uniform float u_line;

in vec2 v_texcoord;
in float v_heat;
out vec4 colour;

const float LINES = 10.0;

vec4 ramp(float heat) {
  float at = clamp(heat, 0.0, 1.0) * 5.0;
  int below = min(int(at), 4);
  return mix(u_ramp[below], u_ramp[below + 1], at - float(below));
}

// The fraction of a pixel that a band covers, at a distance from the middle of the band. Lengths in pixels.
float coverage(float distance, float width) {
  return clamp(0.5 + 0.5 * width - distance, 0.0, 1.0);
}

void main() {
  vec4 picture = texture(u_picture, v_texcoord);
  vec4 shade = ramp(v_heat);
  vec3 mixed = mix(picture.rgb, shade.rgb * picture.a, shade.a);

  float tenths = v_heat * LINES;
  float slope = length(vec2(dFdx(tenths), dFdy(tenths)));
  float line = clamp(round(tenths), 1.0, LINES - 1.0);
  float off = abs(tenths - line) / max(slope, 1e-6);
  float bold = line == 5.0 ? 2.0 : 1.0;
  // Dense lines would merge into a dark spot, so they fade out.
  float fade = u_line == 0.0 ? 0.0 : 1.0 - smoothstep(0.15, 0.4, slope * u_line);
  float pale = 0.35 * fade * coverage(off, (bold + 2.0) * u_line);
  float dark = (bold > 1.0 ? 0.85 : 0.65) * fade * coverage(off, bold * u_line);
  mixed = mix(mixed, vec3(picture.a), pale);
  colour = vec4(mix(mixed, vec3(0.03, 0.05, 0.16) * picture.a, dark), picture.a);
}
