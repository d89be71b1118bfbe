#pragma once
// Tetrahedra in a tree of boxes: which holds a point, and what others have in common with them.

#include <cstdint>
#include <limits>
#include <vector>

#include "core/base/box_tree.h"
#include "core/fields/cells.h"
#include "core/mesh/handle.h"

namespace aomd::fields {

/// Some tetrahedra of a mesh, which must outlive the tree. Built in O(n log n); about 230 bytes
/// each.
class TetTree {
 public:
  TetTree(const Cells& regions, const std::vector<std::uint32_t>& cells, int threads = 1);

  [[nodiscard]] bool empty() const { return tets_.empty(); }

  /// The region that holds a point, or the one whose affine function has to be carried on least to
  /// reach it: its smallest barycentric coordinate is the largest. So a sliver near by is not taken
  /// where a well shaped one is. no_index where the tree is empty, or holds flat ones alone.
  [[nodiscard]] std::uint32_t region_at(const glm::dvec3& p) const;

  /// Calls visit(region, volume) for those that have a part of `tet` in common with it;
  /// takes(region) says which are asked.
  template <typename Takes, typename Visit>
  void each_overlap(const Tet& tet, const Takes& takes, Visit&& visit) const;

 private:
  struct Best {
    std::uint32_t region = no_index;
    double inside = -std::numeric_limits<double>::infinity();
  };
  void look(const glm::dvec3& p, double radius, Best& best) const;

  BoxTree boxes_;
  std::vector<Tet> tets_;             ///< in the tree's order
  std::vector<double> volumes_;       ///< likewise
  std::vector<std::uint32_t> cells_;  ///< likewise: which region each is
  double size_ = 0;                   ///< the mean diagonal of their boxes
};

[[nodiscard]] inline Box box_of(const Tet& tet) {
  Box box;
  for (const glm::dvec3& p : tet) box.add(p);
  return box;
}

/// Box::touches without branches: of boxes that lie close together no comparison can be foretold.
[[nodiscard]] inline bool touching(const Box& a, const Box& b) {
  return (a.low.x <= b.high.x) & (b.low.x <= a.high.x) & (a.low.y <= b.high.y) &
         (b.low.y <= a.high.y) & (a.low.z <= b.high.z) & (b.low.z <= a.high.z);
}

template <typename Takes, typename Visit>
void TetTree::each_overlap(const Tet& tet, const Takes& takes, Visit&& visit) const {
  const TetCoordinates inside(tet);
  if (inside.flat()) return;
  const Box box = box_of(tet);
  boxes_.reached([&](std::uint32_t node) { return touching(boxes_.node(node).box, box); },
                 [&](std::uint32_t n) {
                   if (!touching(boxes_.box(n), box) || !takes(cells_[n])) return;
                   const double volume = share_inside(inside, tets_[n]) * volumes_[n];
                   if (volume > 0) visit(cells_[n], volume);
                 });
}

}  // namespace aomd::fields
