#version 330 core
// Three corners in a row make a face.
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 normal;
layout(location = 2) in vec4 color;
layout(location = 3) in uint flags;

uniform mat4 view;
uniform mat4 projection;
uniform vec4 clip_plane;

out vec3 eye_normal;
out vec4 face_color;
noperspective out vec3 corner_weight;
flat out uint face_flags;

void main() {
  int corner = gl_VertexID % 3;
  corner_weight = vec3(corner == 0, corner == 1, corner == 2);
  eye_normal = mat3(view) * normal.xyz;
  face_color = color;
  face_flags = flags;
  gl_ClipDistance[0] = dot(clip_plane, vec4(position, 1.0));
  gl_Position = projection * (view * vec4(position, 1.0));
}
