#pragma once
// Files that become part of the program when it is built: cmake/EmbedText.cmake.

#include <string_view>

namespace aomd::scene {

struct EmbeddedText {
  std::string_view name;  ///< "surface.vert", "01-stored.lesson"
  std::string_view text;
};

}  // namespace aomd::scene
