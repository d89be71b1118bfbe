#pragma once
// The lessons' files, embedded at build time.

#include <span>

#include "viewer/base/embedded_text.h"

namespace aomd::scene {

/// What cmake/EmbedText.cmake made of assets/lessons/.
[[nodiscard]] std::span<const EmbeddedText> embedded_texts();

}  // namespace aomd::scene
