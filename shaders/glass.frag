#version 330 core
in vec3 eye_normal;
in vec3 eye_place;

uniform vec4 glass_color;  // its alpha: how much of it is seen face on
uniform int orthographic;

out vec4 color;

void main() {
  vec3 towards_eye = orthographic != 0 ? vec3(0.0, 0.0, 1.0) : normalize(-eye_place);
  float facing = abs(dot(normalize(eye_normal), towards_eye));
  // Where one looks along it there is more of it in the way.
  float rim = (1.0 - facing) * (1.0 - facing);
  color = vec4(glass_color.rgb, mix(glass_color.a, 0.85, rim));
}
