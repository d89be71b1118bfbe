#pragma once
// What binary and text STL have in common, and the colours that programs put into the attribute of
// binary facets: five bits a shade.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace aomd::io::detail {

inline constexpr std::size_t header_size = 80, data_start = 84, facet_size = 50;

/// What our writer calls the only solid of a mesh, and the array of attributes that are no colours.
inline constexpr const char *stl_usual_name = "mesh", *stl_mark = "attribute";

/// VisCAM sets the highest bit where a facet has a colour, Magics where it has none of its own.
[[nodiscard]] inline bool stl_colour_is_valid(std::uint16_t mark, bool magics) {
  return ((mark & 0x8000u) != 0) != magics;
}

/// Red, green or blue (0, 1, 2) from 0 to 255. Magics has red in the lowest bits, VisCAM blue.
[[nodiscard]] inline double stl_shade(std::uint16_t mark, int channel, bool magics) {
  const int place = magics ? channel : 2 - channel;
  return std::round((mark >> (5 * place) & 31) * 255.0 / 31);
}

/// A colour, 0 to 1, as VisCAM has it.
[[nodiscard]] inline std::uint16_t stl_coloured(const std::array<double, 3>& colour) {
  unsigned mark = 0x8000u;
  for (std::size_t k = 0; k < 3; ++k) {
    const double shade = std::isfinite(colour[k]) ? std::round(31 * colour[k]) : 0;
    mark |= static_cast<unsigned>(shade < 0 ? 0 : shade > 31 ? 31 : shade) << (5 * (2 - k));
  }
  return static_cast<std::uint16_t>(mark);
}

}  // namespace aomd::io::detail
