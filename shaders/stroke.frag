#version 330 core
flat in vec4 stroke_color;
flat in vec2 half_extent_px;
noperspective in vec2 place_px;

uniform float pixel_scale;
uniform float outline_px;
uniform vec3 outline_color;

out vec4 color;

void main() {
  vec2 outside = vec2(max(abs(place_px.x) - half_extent_px.x, 0.0), place_px.y);
  float reach = half_extent_px.y + 0.5 - length(outside);
  float cover = clamp(reach + outline_px * pixel_scale, 0.0, 1.0);
  if (cover <= 0.0) discard;
  float inside = clamp(reach, 0.0, 1.0);
  float paint = outline_px > 0.0 ? inside : 1.0;
  color = vec4(mix(outline_color, stroke_color.rgb, paint), stroke_color.a * cover);
}
