#pragma once
// The lessons' files, embedded at build time.

#include <span>
#include <string_view>

namespace aomd::scene {

struct EmbeddedText {
  std::string_view name;  ///< "01-stored.lesson"
  std::string_view text;
};

/// What cmake/EmbedText.cmake made of assets/lessons/.
[[nodiscard]] std::span<const EmbeddedText> embedded_texts();

}  // namespace aomd::scene
