#version 330 core
// Three corners in a row make a face. PICTURES: they lie on faces. WIRES: the edges alone. CODES: each third of a face
// in the colour of its edge. A variant for each, since llvmpipe goes both ways at every condition.
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 normal;
layout(location = 2) in vec4 color;
layout(location = 3) in uint flags;
#ifdef PICTURES
layout(location = 4) in vec2 place;  // in the picture on the face, counted upwards
#endif

uniform mat4 view;
uniform mat4 projection;
uniform vec4 clip_plane;
#ifdef PICTURES
uniform int picture;  // the faces to draw are those with this one
#endif

out vec3 eye_normal;
out vec3 face_color;
// Both at once would be more than eight numbers that are interpolated with perspective, with which llvmpipe of Mesa 22
// overruns its memory.
#ifdef PICTURES
out vec2 picture_place;
#else
out float open;  // how much light from all sides comes here
#endif
noperspective out vec3 corner_weight;
flat out uint face_flags;

void main() {
  int corner = gl_VertexID % 3;
  corner_weight = vec3(corner == 0, corner == 1, corner == 2);
  eye_normal = mat3(view) * normal.xyz;
  face_color = color.rgb;
  face_flags = flags;
  gl_ClipDistance[0] = dot(clip_plane, vec4(position, 1.0));
  gl_Position = projection * (view * vec4(position, 1.0));
#ifdef PICTURES
  picture_place = vec2(place.x, 1.0 - place.y);
  if (int(flags >> 20u) != picture) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
#else
  open = color.a;
#endif
}
