#version 330 core
uniform vec3 top;
uniform vec3 bottom;
in float height;
out vec4 color;

void main() {
  // Half a step of ordered noise hides the bands of a gradient in 8 bits.
  float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) - 0.5;
  color = vec4(mix(bottom, top, height) + noise / 255.0, 1.0);
}
