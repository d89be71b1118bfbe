#pragma once
// Where a surface cuts through itself: the check at the end of a decimation (paper, section 4).

#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "core/mesh/mesh.h"

namespace aomd::measure {

/// Two faces that meet in more than the vertex or edge they share; first < second.
struct IntersectingPair {
  Face first, second;
  friend constexpr auto operator<=>(const IntersectingPair&, const IntersectingPair&) = default;
};

/// Every pair of faces that intersect in more than a shared vertex or edge, in ascending order.
/// Vertices are shared when their positions are equal, so seams do not count. Two faces with the
/// same three corners are one pair; two that lie on each other beside a common edge too; faces
/// without area are passed over. Exact: doubtful cases are decided by CGAL's exact predicates, but
/// for coordinates smaller by 60 decades than others of the same pair, which count as 0; all must
/// be finite. About O(n log n): 10 ms for 10 000 faces, and the same for any
/// number of threads. Touches nothing of the mesh.
[[nodiscard]] std::vector<IntersectingPair> self_intersections(const Mesh& mesh, int threads = 1);

/// How many pairs that are, without listing them: copies of one face are counted, not looked at two
/// by two, so that any number of them takes O(n log n).
[[nodiscard]] std::uint64_t count_self_intersections(const Mesh& mesh, int threads = 1);

}  // namespace aomd::measure
