#pragma once
// An edge between two numbered vertices as one number.

#include <cstdint>

namespace aomd {

/// The same whichever way round; in the order of the smaller vertices, then of the larger ones.
[[nodiscard]] constexpr std::uint64_t edge_key(std::uint32_t a, std::uint32_t b) {
  return a < b ? std::uint64_t{a} << 32 | b : std::uint64_t{b} << 32 | a;
}

}  // namespace aomd
