#include "viewer/base/picture_size.h"

#include <cstdint>
#include <cstdio>

#include "core/io/png.h"

namespace aomd::scene {

std::string read_picture_size(const std::string& text, glm::ivec2& size) {
  constexpr int largest_side = 16384;
  char rest = 0;
  const int read = std::sscanf(text.c_str(), "%5dx%5d%c", &size.x, &size.y, &rest);
  const bool good =
      read == 2 && size.x >= 1 && size.y >= 1 && size.x <= largest_side && size.y <= largest_side;
  if (!good) return "'" + text + "' is not a size like 1280x800";
  const bool small = static_cast<std::uint64_t>(size.x) * static_cast<std::uint64_t>(size.y) <=
                     io::max_image_pixels;
  return small ? "" : "'" + text + "' is too large: 8192x8192 is as many pixels as there may be";
}

}  // namespace aomd::scene
