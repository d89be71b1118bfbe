#version 330 core
layout(location = 0) in vec2 position;
layout(location = 1) in vec2 texture_place;
layout(location = 2) in vec4 color;

uniform vec4 scale_offset;  // from ImGui's coordinates to clip space

out vec2 fragment_place;
out vec4 fragment_color;

void main() {
  fragment_place = texture_place;
  fragment_color = color;
  gl_Position = vec4(position * scale_offset.xy + scale_offset.zw, 0.0, 1.0);
}
