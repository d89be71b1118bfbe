#include "viewer/drawing/palette.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include <glm/common.hpp>

namespace aomd::scene {
namespace {

// Okabe and Ito's hues, ordered so that neighbouring tags lie far apart. Black gives way to a slate
// violet, because a tint of black is the neutral colour.
constexpr std::array<Color, 8> hues = {
    rgb(0x56b4e9),  // sky blue
    rgb(0xe69f00),  // orange
    rgb(0x009e73),  // bluish green
    rgb(0xcc79a7),  // reddish purple
    rgb(0xf0e442),  // yellow
    rgb(0x0072b2),  // blue
    rgb(0xd55e00),  // vermilion
    rgb(0x7a6fb0),  // slate violet
};

// After each turn through the hues the tints step in lightness: as far as each other, never to the
// strong colours of edges and vertices.
constexpr std::array<float, 3> face_whiteness = {0.55f, 0.70f, 0.40f};

// Van der Walt and Smith's maps, from an eighth (viridis) and a quarter (magma) of their way on;
// Nunez, Anderton and Renslow's from a quarter.
constexpr std::array<Color, 8> viridis = {rgb(0x3e4989), rgb(0x31688e), rgb(0x26828e),
                                          rgb(0x1f9e89), rgb(0x35b779), rgb(0x6ece58),
                                          rgb(0xb5de2b), rgb(0xfde725)};
constexpr std::array<Color, 7> magma = {rgb(0x50127b), rgb(0x812581), rgb(0xb5367a), rgb(0xe55964),
                                        rgb(0xfb8861), rgb(0xfec287), rgb(0xfcfdbf)};
constexpr std::array<Color, 7> cividis = {rgb(0x434e6c), rgb(0x5d636e), rgb(0x777776),
                                          rgb(0x938d78), rgb(0xb1a570), rgb(0xd3c164),
                                          rgb(0xffea46)};
constexpr std::array<Color, 2> grey = {rgb(0x404040), rgb(0xf2f2f2)};

std::span<const Color> stops_of(ColorMap map) {
  switch (map) {
    case ColorMap::Magma:
      return magma;
    case ColorMap::Cividis:
      return cividis;
    case ColorMap::Grey:
      return grey;
    default:
      return viridis;
  }
}

struct Place {
  std::size_t hue = 0;
  std::size_t turn = 0;
};

Place place_of(ModelRef ref) {
  // Tags start at 1 in most files and may be negative.
  const auto n = static_cast<std::uint32_t>(ref.tag() - 1) & 0x1fffffffu;
  return {n % hues.size(), n / hues.size()};
}

Color tint(Place place, float whiteness) {
  return mix_colors(hues[place.hue], rgb(0xffffff), whiteness);
}
Color shade(Place place, float blackness) {
  return mix_colors(hues[place.hue], rgb(0x10131a), blackness);
}

}  // namespace

Color pack_color(const glm::vec4& rgba) {
  const glm::vec4 bytes = glm::round(glm::clamp(rgba, 0.0f, 1.0f) * 255.0f);
  return static_cast<Color>(bytes.r) | static_cast<Color>(bytes.g) << 8 |
         static_cast<Color>(bytes.b) << 16 | static_cast<Color>(bytes.a) << 24;
}

glm::vec4 unpack_color(Color color) {
  return glm::vec4(color & 0xffu, color >> 8 & 0xffu, color >> 16 & 0xffu, color >> 24) / 255.0f;
}

Color mix_colors(Color a, Color b, float t) {
  return pack_color(glm::mix(unpack_color(a), unpack_color(b), t));
}

Color ramp_color(float t, ColorMap map) {
  const std::span<const Color> stops = stops_of(map);
  const float at = std::clamp(t, 0.0f, 1.0f) * static_cast<float>(stops.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(at), stops.size() - 2);
  return mix_colors(stops[below], stops[below + 1], at - static_cast<float>(below));
}

Color color_of(ModelRef ref) {
  if (!ref.valid()) return unclassified_color();
  if (ref == unnamed_border) return plain_line_color();
  const Place place = place_of(ref);
  const float step = 0.12f * static_cast<float>(place.turn % 3);
  switch (ref.dimension()) {
    case 0:
      return shade(place, 0.10f + step);
    case 1:
      return shade(place, 0.30f + step);
    default:
      return tint(place, face_whiteness[place.turn % face_whiteness.size()]);
  }
}

}  // namespace aomd::scene
