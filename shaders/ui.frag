#version 330 core
in vec2 fragment_place;
in vec4 fragment_color;
uniform sampler2D atlas;
out vec4 color;

void main() { color = fragment_color * texture(atlas, fragment_place); }
