#pragma once
// The page that shows a suite, embedded at build time.

#include <span>

#include "viewer/base/embedded_text.h"

namespace aomd::suite {

/// What cmake/EmbedText.cmake made of assets/suite/.
[[nodiscard]] std::span<const scene::EmbeddedText> embedded_texts();

}  // namespace aomd::suite
