#version 330 core
// One instance a line with round ends, or a disc, which is a line from a point to itself: a rectangle on the
// screen around both ends.
layout(location = 0) in vec3 a;
layout(location = 1) in vec3 b;
layout(location = 2) in vec4 color;
layout(location = 3) in float thickness_px;  // a line's width or a disc's radius
layout(location = 4) in float room;          // how far the next disc is; 0: whatever is there

uniform mat4 view;
uniform mat4 projection;
uniform vec4 clip_plane;
uniform vec2 size_px;
uniform float pixel_scale;
uniform float half_width_per_thickness;
uniform float outline_px;
uniform float pull_px;  // towards the eye, besides the width
uniform float pixel_size;
uniform float near_depth;
uniform int orthographic;

flat out vec4 stroke_color;
flat out vec2 half_extent_px;    // half the length, half the width
noperspective out vec2 place_px;  // from the middle: along, across

// Pulls a point towards the eye by some pixels; it stays where it is on the screen.
vec3 pulled(vec3 p, float pixels) {
  return orthographic != 0 ? p + vec3(0.0, 0.0, pixels * pixel_size) : p * (1.0 - pixels * pixel_size);
}

void main() {
  float half_width = thickness_px * half_width_per_thickness * pixel_scale;
  vec3 p = (view * vec4(a, 1.0)).xyz;
  vec3 q = (view * vec4(b, 1.0)).xyz;
  float apart_px = room / (orthographic != 0 ? pixel_size : max(-p.z, near_depth) * pixel_size);
  float crowded = room > 0.0 ? smoothstep(1.2, 2.4, apart_px / (half_width + outline_px * pixel_scale)) : 1.0;
  bool at_b = (gl_VertexID & 1) != 0;
  stroke_color = vec4(color.rgb, color.a * crowded);
  gl_ClipDistance[0] = dot(clip_plane, vec4(at_b ? b : a, 1.0));
  // What lies behind the eye has no place on the screen: cut the line at the near plane.
  float p_in = -p.z - near_depth;
  float q_in = -q.z - near_depth;
  if (half_width <= 0.0 || crowded <= 0.0 || (p_in < 0.0 && q_in < 0.0)) {
    half_extent_px = vec2(0.0);
    place_px = vec2(0.0);
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    return;
  }
  if (p_in < 0.0) p = mix(p, q, p_in / (p_in - q_in));
  if (q_in < 0.0) q = mix(q, p, q_in / (q_in - p_in));
  // Half the line's width lies over faces that may rise towards the eye.
  float pull = 3.0 * half_width + pull_px * pixel_scale;
  vec4 clip_p = projection * vec4(pulled(p, pull), 1.0);
  vec4 clip_q = projection * vec4(pulled(q, pull), 1.0);

  vec2 screen_p = 0.5 * size_px * clip_p.xy / clip_p.w;
  vec2 screen_q = 0.5 * size_px * clip_q.xy / clip_q.w;
  float line_length = distance(screen_p, screen_q);
  vec2 along = line_length > 1e-4 ? (screen_q - screen_p) / line_length : vec2(1.0, 0.0);
  float border = half_width + outline_px * pixel_scale + 1.0;
  vec2 offset = vec2(at_b ? border : -border, (gl_VertexID & 2) != 0 ? border : -border);
  half_extent_px = vec2(0.5 * line_length, half_width);
  place_px = vec2((at_b ? half_extent_px.x : -half_extent_px.x) + offset.x, offset.y);
  vec2 screen = (at_b ? screen_q : screen_p) + along * offset.x + vec2(-along.y, along.x) * offset.y;
  vec4 clip = at_b ? clip_q : clip_p;
  gl_Position = vec4(screen / (0.5 * size_px) * clip.w, clip.zw);
}
