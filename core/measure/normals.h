#pragma once
// How far the faces of a result have turned from the surface that they stand for.

#include <cstddef>

#include "core/mesh/mesh.h"
#include "core/model/triangle_tree.h"

#pragma GCC visibility push(default)

namespace aomd::measure {

/// Numbers of triangles by the angle between their normal and the original's, seen from their
/// middle.
struct NormalDeviation {
  std::size_t triangles = 0;  ///< all, also those without area, which are counted nowhere else
  std::size_t above_10deg = 0;
  std::size_t above_60deg = 0;
  std::size_t flips = 0;  ///< above 90 degrees: they look away

  /// Percent of all triangles; 0 when there are none.
  [[nodiscard]] double percent(std::size_t count) const {
    return triangles ? 100.0 * static_cast<double>(count) / static_cast<double>(triangles) : 0;
  }
};

/// Compares every triangle of `result` (a quad counts as two) with the triangle of the original
/// that is nearest to its barycentre. Where several are equally near, at edges and vertices, the
/// one that agrees best counts. Without an original nothing deviates. The same for any number of
/// threads. About O(faces log originals).
[[nodiscard]] NormalDeviation measure_normals(const TriangleTree& original, const Mesh& result,
                                              int threads = 1);

}  // namespace aomd::measure

#pragma GCC visibility pop
