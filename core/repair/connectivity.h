#pragma once
// What hangs together: sets of corners, vertices or faces, and the faces at each edge.

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/disjoint_sets.h"
#include "core/base/edge_key.h"
#include "core/base/raw_vector.h"
#include "core/repair/surface.h"

namespace aomd::repair_detail {

/// The living faces connected through shared vertices: a set of vertices for each piece.
[[nodiscard]] DisjointSets pieces_of(const Surface& surface);

/// The sides of all living faces, edge by edge.
class EdgeUses {
 public:
  struct Use {
    std::uint32_t high;  ///< the larger of the edge's vertices
    std::uint32_t
        place;  ///< corner << 1 | 1 where the side runs from the smaller vertex to the larger
    [[nodiscard]] std::uint32_t corner() const { return place >> 1; }
    [[nodiscard]] bool forward() const { return (place & 1u) != 0; }
  };
  explicit EdgeUses(const Surface& surface);

  /// Calls visit(span of uses) for every edge, ascending by its vertices; uses are ascending by
  /// corner.
  template <typename Visit>
  void each(Visit&& visit) const {
    for (std::size_t i = 0, j = 0; i < uses_.size(); i = j) {
      for (j = i + 1; j < uses_.size() && uses_[j].high == uses_[i].high && !starts_[j];) ++j;
      visit(std::span<const Use>(uses_.data() + i, j - i));
    }
  }

 private:
  RawVector<Use> uses_;               ///< by smaller vertex, then larger, then corner
  std::vector<std::uint8_t> starts_;  ///< 1 where the smaller vertex changes
};

}  // namespace aomd::repair_detail
