#include "viewer/drawing/edge_codes.h"

#include <array>

namespace aomd::scene {

Color verdict_color(std::uint8_t code) {
  constexpr std::array<Color, reason_count> colors = {
      rgb(0x1fa37a),  // could go
      rgb(0xd9dee5),  // spacing: what most edges of a finished mesh are
      rgb(0x2f7fc1),  // shape of the model
      rgb(0x7b4fb5),  // topology
      rgb(0x8c5a2b),  // flat face
      rgb(0xe0662f),  // angle
      rgb(0xd98cb3),  // quality
      rgb(0x555e6b),  // kept
      rgb(0xe8c52e),  // shape
      rgb(0x6cc3ea),  // distance
      rgb(0xb0214f),  // intersection
      rgb(0x11203a),  // inverted
      rgb(0xb5c34a),  // overshoot
      rgb(0xf3b58c),  // volume
  };
  return code < colors.size() ? colors[code] : plain_face_color();
}

}  // namespace aomd::scene
