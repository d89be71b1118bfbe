#pragma once
// Pictures of materials: PNG and JPEG in memory.

#include <string>
#include <string_view>

#include "core/io/png.h"

namespace aomd::io {

/// Reads a PNG or JPEG. `name` stands in messages. Throws ReadError for what is neither or damaged,
/// LimitError for more than max_image_pixels.
[[nodiscard]] Image decode_picture(const std::string& name, std::string_view bytes);

}  // namespace aomd::io
