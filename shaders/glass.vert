#version 330 core
// A surface of glass: where it is, not what it lies on.
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 normal;

uniform mat4 view;
uniform mat4 projection;
uniform vec4 clip_plane;

out vec3 eye_normal;
out vec3 eye_place;

void main() {
  vec4 place = view * vec4(position, 1.0);
  eye_normal = mat3(view) * normal.xyz;
  eye_place = place.xyz;
  gl_ClipDistance[0] = dot(clip_plane, vec4(position, 1.0));
  gl_Position = projection * place;
}
