#version 300 es
// The picture, premultiplied.
precision highp float;

uniform sampler2D u_picture;

in vec2 v_texcoord;
out vec4 colour;

void main() {
  colour = texture(u_picture, v_texcoord);
}
