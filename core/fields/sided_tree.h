#pragma once
// Which piece of a surface a point beside it belongs to, where pieces lie close to each other.

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/fields/cells.h"
#include "core/mesh/handle.h"
#include "core/model/triangle_tree.h"

namespace aomd::fields {

/// From where a point looks at a surface.
struct Side {
  glm::dvec3 direction{};         ///< of what it is a point of
  double reach = 0;               ///< how far what agrees with it may be
  std::uint32_t part = no_index;  ///< of the surface, or all of it
};

/// Triangles, or segments as triangles with two corners in one place. Each belongs to a part, and
/// triangles have a direction: their normal.
class SidedTree {
 public:
  struct Item {
    std::array<std::uint32_t, 3> corners{};  ///< vertices
    std::uint32_t owner = no_index;          ///< the face that it is of
    std::uint32_t part = 0;
    glm::dvec3 direction{};
  };

  /// Built in O(n log n).
  SidedTree(const std::vector<glm::dvec3>& positions, std::vector<Item> items, int threads);

  [[nodiscard]] bool empty() const { return items_.empty(); }
  [[nodiscard]] std::vector<Item>& items() { return items_; }

  /// The nearest of the part whose direction is within 90 degrees of the side's and that is within
  /// reach; else the nearest of the part, else of all. Null where there is none at all.
  [[nodiscard]] const Item* nearest(const glm::dvec3& p, const Side& side) const;
  /// Calls visit(item) for those of the part (else of all) that are nearest, up to rounding.
  template <typename Visit>
  void each_nearest(const glm::dvec3& p, std::uint32_t part, Visit&& visit) const;

 private:
  template <typename Takes>
  [[nodiscard]] TriangleTree::Nearest look(
      const glm::dvec3& p, const Takes& takes,
      double most2 = std::numeric_limits<double>::infinity()) const;
  /// Of the part, or of all where it has none.
  [[nodiscard]] TriangleTree::Nearest nearest_in(const glm::dvec3& p, std::uint32_t part) const;

  std::vector<Item> items_;
  TriangleTree tree_;
};

/// Faces as fans around their first vertex, all of part 0.
[[nodiscard]] std::vector<SidedTree::Item> face_items(const Cells& faces);

template <typename Visit>
void SidedTree::each_nearest(const glm::dvec3& p, std::uint32_t part, Visit&& visit) const {
  const TriangleTree::Nearest found = nearest_in(p, part);
  if (found.triangle == no_index) return;
  const std::uint32_t own = items_[tree_.source(found.triangle)].part;
  const double reach = std::sqrt(found.distance2) + 1e-9 * std::sqrt(tree_.diagonal2());
  tree_.within(p, reach * reach, [&](std::uint32_t n) {
    const Item& item = items_[tree_.source(n)];
    if (part == no_index || item.part == own) visit(item);
  });
}

}  // namespace aomd::fields
