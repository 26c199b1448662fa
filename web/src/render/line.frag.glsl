#version 300 es
// One colour, premultiplied.
precision highp float;

uniform vec4 u_colour;

out vec4 colour;

void main() {
  colour = u_colour;
}
