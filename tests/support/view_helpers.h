#pragma once
// Small meshes in a session, and what is drawn of them.

#include "tests/support/session_helpers.h"

namespace aomd::scene::test {

inline void load(Session& s, const MeshData& data) {
  s.show(make_loaded(data, "test"));
  s.sheet().drawing().set_bounds(s.document().content().bounds);
  s.refresh();
}

inline std::span<const Corner> corners(Session& s) {
  return s.sheet().drawing().drawable().corners.values();
}

/// n x n x n unit cubes.
inline MeshData cubes(std::uint32_t n) {
  MeshData data;
  const std::uint32_t m = n + 1;
  const auto at = [&](std::uint32_t x, std::uint32_t y, std::uint32_t z) {
    return (x * m + y) * m + z;
  };
  for (std::uint32_t x = 0; x < m; ++x)
    for (std::uint32_t y = 0; y < m; ++y)
      for (std::uint32_t z = 0; z < m; ++z) data.positions.emplace_back(x, y, z);
  for (std::uint32_t x = 0; x < n; ++x)
    for (std::uint32_t y = 0; y < n; ++y)
      for (std::uint32_t z = 0; z < n; ++z)
        data.regions.add(
            Shape::Hexahedron,
            {at(x, y, z), at(x + 1, y, z), at(x + 1, y + 1, z), at(x, y + 1, z), at(x, y, z + 1),
             at(x + 1, y, z + 1), at(x + 1, y + 1, z + 1), at(x, y + 1, z + 1)},
            ModelRef(3, 1));
  return data;
}

}  // namespace aomd::scene::test
