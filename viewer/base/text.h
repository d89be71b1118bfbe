#pragma once
// Numbers as people read them.

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/text.h"

namespace aomd::scene {

using aomd::grouped;
using aomd::joined;

/// "1 face", "7,160 faces", "2 vertices".
[[nodiscard]] std::string counted(std::int64_t n, std::string_view one);
template <std::unsigned_integral N>
[[nodiscard]] std::string counted(N n, std::string_view one) {
  return counted(static_cast<std::int64_t>(n), one);
}

/// "+12", "−1,234", "±0".
[[nodiscard]] std::string signed_grouped(std::int64_t n);

/// "7 faces, 15 edges, 10 vertices": by dimension, the highest first; what there is none of is left
/// out.
[[nodiscard]] std::string counts_text(const std::array<std::size_t, 4>& counts);

/// "934 B", "1.4 KB", "21.7 MB": powers of 1000.
[[nodiscard]] std::string bytes_text(std::size_t bytes);

/// The shortest text with at most `digits` after the point: "10", "2.5".
[[nodiscard]] std::string short_number(double value, int digits = 3);

/// Three significant digits: "0.00144", "12.3", "4.5e-07".
[[nodiscard]] std::string significant(double value);

}  // namespace aomd::scene
