#pragma once
// Triangles without their copies, so that what is asked of each is asked once.

#include <cstdint>
#include <vector>

#include "core/model/triangle_tree.h"

namespace aomd::measure {

struct DistinctTriangles {
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> copies;  ///< of each, itself among them; empty where there is one each

  [[nodiscard]] std::size_t count(std::size_t i) const { return copies.empty() ? 1 : copies[i]; }
};

/// Where hundreds may be the same (crowded() in crowded_pairs.h): the first of each set with the
/// same corners the same way round, in their order. Else all of them as they are. O(n log n).
[[nodiscard]] DistinctTriangles distinct(std::vector<Triangle> triangles);

}  // namespace aomd::measure
