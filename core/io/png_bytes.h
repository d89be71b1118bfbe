#pragma once
// PNG in memory.

#include <string>
#include <string_view>

#include "core/io/png.h"

namespace aomd::io::detail {

/// As read_png() reads a file.
[[nodiscard]] Image decode_png(const std::string& name, std::string_view bytes);

}  // namespace aomd::io::detail
