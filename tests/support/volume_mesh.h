#pragma once
// What the tests of regions need of a mesh.

#include <initializer_list>
#include <vector>

#include "core/mesh/mesh.h"

namespace aomd::test {

/// Stores all relations. Edges come first: their order is then that of the regions.
inline void set_all(Mesh& mesh) {
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      if (i != j) mesh.set(i, j);
}

inline std::vector<Vertex> vertices(std::initializer_list<std::uint32_t> ids) {
  return {ids.begin(), ids.end()};
}

}  // namespace aomd::test
