#version 300 es
// Drawn pixels of an export, each as a square.
precision highp float;

uniform sampler2D u_sheet;
uniform vec2 u_canvas_size;
// Device pixels per pixel of the export, and the place of the sheet's corner, from the top left.
uniform vec3 u_grid;
// Each pixel of the export has a square of so many texels a side. It is an odd number.
uniform int u_texels;

out vec4 colour;

void main() {
  vec2 device = vec2(gl_FragCoord.x, u_canvas_size.y - gl_FragCoord.y);
  ivec2 size = textureSize(u_sheet, 0);
  ivec2 pixel = clamp(ivec2(floor((device - u_grid.yz) / u_grid.x)), ivec2(0), size / u_texels - 1);
  ivec2 middle = pixel * u_texels + u_texels / 2;
  colour = texelFetch(u_sheet, ivec2(middle.x, size.y - 1 - middle.y), 0);
}
