#version 330 core
in vec3 eye_normal;
in vec3 face_color;
noperspective in vec3 corner_weight;
flat in uint face_flags;
#ifdef PICTURES
in vec2 picture_place;
uniform int picture;  // greater than 0: the one that is bound lies on all faces; 0: none does
uniform sampler2D picture_colors;
#else
in float open;
#endif

uniform int light;
uniform vec4 edge_color;
uniform float edge_width;
uniform float pixel_scale;
uniform vec4 back_color;
uniform vec4 highlight_color;

out vec4 color;

uniform float strength;  // of the colour
uniform vec3 key_direction;
uniform vec3 half_direction;  // between the key light and the eye
uniform vec3 fill_direction;
uniform vec3 sky_direction;

vec3 lit(vec3 base, vec3 n, float open) {
  float sky = 0.5 + 0.5 * dot(n, sky_direction);
  vec3 ambient = mix(vec3(0.29, 0.28, 0.275), vec3(0.43, 0.44, 0.46), sky);
  float key = max(dot(n, key_direction), 0.0);
  float fill = max(dot(n, fill_direction), 0.0);
  float rim = 1.0 - max(n.z, 0.0);
  float gloss = max(dot(n, half_direction), 0.0);
  gloss *= gloss;
  gloss *= gloss;
  gloss *= gloss;
  gloss *= gloss;
  gloss *= gloss;
  // What lies deep gets less of the sky, and some less of the lights, which are not small.
  ambient *= open * open;
  vec3 light = ambient + (key * vec3(0.60, 0.59, 0.57) + fill * vec3(0.17, 0.18, 0.20)) * open;
  return base * light + (vec3(0.045 * gloss) + 0.10 * rim * rim * rim * sky) * open;
}

// How much of this pixel is covered by the face's edges, in [0,1].
float edge_cover() {
  vec3 slope = vec3(length(vec2(dFdx(corner_weight.x), dFdy(corner_weight.x))),
                    length(vec2(dFdx(corner_weight.y), dFdy(corner_weight.y))),
                    length(vec2(dFdx(corner_weight.z), dFdy(corner_weight.z))));
  vec3 distance_px = corner_weight / max(slope, 1e-6);
  float nearest = 1e6;
  if ((face_flags & 1u) == 0u) nearest = min(nearest, distance_px.z);
  if ((face_flags & 2u) == 0u) nearest = min(nearest, distance_px.x);
  if ((face_flags & 4u) == 0u) nearest = min(nearest, distance_px.y);
  // The radius of the face's inner circle in pixels: where it is small, lines would paint the face over.
  float radius_px = 1.0 / max(slope.x + slope.y + slope.z, 1e-6);
  float fade = smoothstep(1.2, 4.5, radius_px / pixel_scale);
  return fade * clamp(0.5 * edge_width * pixel_scale + 0.5 - nearest, 0.0, 1.0);
}

#ifdef CODES
uniform vec3 code_colors[16];

// The colour of the side that is nearest: each has a third of the face, so that an edge's two faces form a diamond.
vec3 code_color() {
  vec3 w = corner_weight;
  uint side = w.z <= w.x && w.z <= w.y ? 0u : w.x <= w.y ? 1u : 2u;
  return code_colors[(face_flags >> (8u + 4u * side)) & 15u];
}
#endif

#ifdef WIRES
void main() {
  float cover = edge_color.a * edge_cover();
  if (cover <= 0.0) discard;
  color = vec4(edge_color.rgb, cover);
}
#else
void main() {
  vec3 n = normalize(eye_normal);
#ifdef CODES
  vec3 base = code_color();
#else
  vec3 base = face_color * strength;
#endif
#ifdef PICTURES
  const float open = 1.0;
  if (picture > 0) {
    vec4 shown = texture(picture_colors, picture_place);
    base *= mix(vec3(1.0), shown.rgb, shown.a);
  }
#endif
  if ((face_flags & 16u) != 0u) {
    if (n.z < 0.0) n = -n;
  } else if (!gl_FrontFacing) {
    n = -n;
    // Stripes tell a back from a face of that colour, also to colour-blind eyes.
    float stripe = step(0.5, fract((gl_FragCoord.x + gl_FragCoord.y) / (10.0 * pixel_scale)));
    base = mix(base, back_color.rgb, back_color.a) * (1.0 - 0.14 * stripe);
  }
  if ((face_flags & 8u) != 0u) base = mix(base, highlight_color.rgb, highlight_color.a);
  // Squares and roots stand in for the sRGB curve.
  vec3 shaded = light != 0 ? sqrt(min(lit(base * base, n, open), 1.0)) : base;
  color = vec4(mix(shaded, edge_color.rgb, edge_color.a * edge_cover()), 1.0);
}
#endif
