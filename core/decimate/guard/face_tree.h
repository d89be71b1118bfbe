#pragma once
// The present faces of a mesh that changes, in a tree of boxes.

#include <cstdint>
#include <vector>

#include "core/base/box_tree.h"
#include "core/mesh/column.h"
#include "core/mesh/mesh.h"
#include "core/model/triangle_tree.h"

namespace aomd {

/// The faces of a mesh, found by boxes; of a volume those on model faces. A face that changes keeps
/// its place in the tree, and the boxes above it follow; operations are local, so that the places
/// stay good. Once half of the faces are gone, the tree is built anew: faces of any sizes mix, and
/// they grow as a decimation goes on. Only triangles change: quads, sides of regions that are no
/// tetrahedra, stay as they are.
class FaceTree {
 public:
  /// A face and its corners; none once it is gone. A quad is two triangles, of which the tree holds
  /// the second.
  struct Item {
    Triangle corners;
    Face face;
    std::uint32_t half = no_index;
  };

  /// O(n log n); about 170 bytes a face. T(2,0) must be stored.
  explicit FaceTree(const Mesh& mesh);

  /// Whether a triangle cuts a face.
  [[nodiscard]] bool cuts(const Triangle& t, const Item& item) const;

  [[nodiscard]] const Item& item(Face f) const { return items_[place_[f]]; }
  /// Takes a face out for good. O(log n).
  void remove(Face f);
  /// Gives a face new corners. O(log n).
  void put(Face f, const Triangle& corners);
  /// Builds anew where that pays.
  void tidy();

  /// Calls visit(item, box) for every face with area whose box touches.
  template <typename Visit>
  void touching(const Box& box, Visit&& visit) const {
    boxes_.touching(box, [&](std::uint32_t n) { visit(items_[n], boxes_.box(n)); });
  }

 private:
  [[nodiscard]] Item item_of(const Mesh& mesh, Face f);
  [[nodiscard]] Box box_of(const Item& item) const;
  void build(const std::vector<Item>& items);

  BoxTree boxes_;            ///< those of faces that are gone or have no area are empty
  std::vector<Item> items_;  ///< in the order of the tree
  std::vector<Triangle> halves_;
  Column<Face, std::uint32_t> place_;
  std::size_t present_ = 0;
};

}  // namespace aomd
