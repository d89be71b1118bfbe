#pragma once
// A curve that goes through all cells of a cube, each next to the one before.

#include <array>
#include <cstddef>
#include <cstdint>

namespace aomd {

/// The place of a cell of a cube of 2^bits cells along each side on Hilbert's curve (Skilling,
/// "Programming the Hilbert curve", 2004). At most 10 bits.
[[nodiscard]] inline std::uint32_t hilbert_place(std::array<std::uint32_t, 3> x, int bits) {
  const std::uint32_t top = 1u << (bits - 1);
  for (std::uint32_t q = top; q > 1; q >>= 1)
    for (std::uint32_t& coordinate : x) {
      const std::uint32_t low = q - 1, swapped = (x[0] ^ coordinate) & low;
      if ((coordinate & q) != 0) {
        x[0] ^= low;
      } else {
        x[0] ^= swapped;
        coordinate ^= swapped;
      }
    }
  x[1] ^= x[0];
  x[2] ^= x[1];
  std::uint32_t flip = 0;
  for (std::uint32_t q = top; q > 1; q >>= 1)
    if ((x[2] & q) != 0) flip ^= q - 1;
  std::uint32_t place = 0;
  for (std::uint32_t q = top; q > 0; q >>= 1)
    for (const std::uint32_t coordinate : x)
      place = place << 1 | std::uint32_t{((coordinate ^ flip) & q) != 0};
  return place;
}

}  // namespace aomd
