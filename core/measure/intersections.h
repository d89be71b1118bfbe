#pragma once
// Where a surface cuts through itself: the check at the end of a decimation (paper, section 4).

#include <compare>
#include <cstddef>
#include <span>
#include <vector>

#include "core/mesh/mesh.h"

#pragma GCC visibility push(default)

namespace aomd::measure {

/// Two faces that meet in more than the vertex or edge they share; first < second.
struct IntersectingPair {
  Face first, second;
  friend constexpr auto operator<=>(const IntersectingPair&, const IntersectingPair&) = default;
};

/// Every pair of faces that intersect in more than a shared vertex or edge, in ascending order.
/// Vertices are shared when their positions are equal, so seams do not count. Two faces with the
/// same three corners are one pair; two that lie on each other beside a common edge too; faces
/// without area are passed over. Exact: doubtful cases are decided by CGAL's exact predicates;
/// coordinates must be finite. About O(n log n) and the pairs that are listed, which many copies of
/// one face make quadratic: 10 ms for 10 000 faces, and the same for any number of threads. Touches
/// nothing of the mesh.
[[nodiscard]] std::vector<IntersectingPair> self_intersections(const Mesh& mesh, int threads = 1);

/// How many pairs there are, and which come first.
struct IntersectionCount {
  std::size_t pairs = 0;
  /// At most 8, in ascending order; of many copies of one face the first stands for all.
  std::vector<IntersectingPair> first;
};

/// The pairs of self_intersections() counted: O(n) memory, and no more than O(n log n) time for any
/// number of copies of a face.
[[nodiscard]] IntersectionCount count_self_intersections(const Mesh& mesh, int threads = 1);

}  // namespace aomd::measure

#pragma GCC visibility pop
