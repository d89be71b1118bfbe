#version 330 core
// Three corners in a row make a face.
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 normal;
layout(location = 2) in vec4 color;
layout(location = 3) in uint flags;
layout(location = 4) in vec2 place;  // in the picture on the face, counted upwards

uniform mat4 view;
uniform mat4 projection;
uniform vec4 clip_plane;
uniform int picture;  // the faces to draw are those with this one; -1: all

out vec3 eye_normal;
out vec3 face_color;
// Where in the picture; without pictures x is how much light from all sides comes here. Both at once would be more than
// eight numbers that are interpolated with perspective, with which llvmpipe of Mesa 22 overruns its memory.
out vec2 picture_place;
noperspective out vec3 corner_weight;
flat out uint face_flags;

void main() {
  int corner = gl_VertexID % 3;
  corner_weight = vec3(corner == 0, corner == 1, corner == 2);
  eye_normal = mat3(view) * normal.xyz;
  face_color = color.rgb;
  face_flags = flags;
  picture_place = picture >= 0 ? vec2(place.x, 1.0 - place.y) : vec2(color.a, 0.0);
  gl_ClipDistance[0] = dot(clip_plane, vec4(position, 1.0));
  gl_Position = projection * (view * vec4(position, 1.0));
  if (picture >= 0 && int(flags >> 20u) != picture) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
}
