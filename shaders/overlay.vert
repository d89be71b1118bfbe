#version 330 core
// Tinted triangles on the surface.
layout(location = 0) in vec3 position;
layout(location = 2) in vec4 color;

uniform mat4 view;
uniform mat4 projection;
uniform vec4 clip_plane;
uniform float pixel_size;
uniform float pixel_scale;
uniform int orthographic;

out vec4 tint;

void main() {
  vec3 p = (view * vec4(position, 1.0)).xyz;
  gl_ClipDistance[0] = dot(clip_plane, vec4(position, 1.0));
  // Two pixels towards the eye: it stays where it is on the screen.
  float pull = 2.0 * pixel_scale * pixel_size;
  p = orthographic != 0 ? p + vec3(0.0, 0.0, pull) : p * (1.0 - pull);
  tint = color;
  gl_Position = projection * vec4(p, 1.0);
}
