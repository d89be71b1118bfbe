#version 330 core
// One triangle that covers the screen.
uniform float from;  // of the whole picture's height, where this is a piece of it
uniform float part;
out float height;

void main() {
  vec2 corner = vec2((gl_VertexID & 1) * 4 - 1, (gl_VertexID >> 1) * 4 - 1);
  height = from + part * (0.5 + 0.5 * corner.y);
  gl_Position = vec4(corner, 0.0, 1.0);
}
