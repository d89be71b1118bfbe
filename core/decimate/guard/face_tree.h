#pragma once
// A tree of boxes over the present faces of a mesh that changes.

#include <cstdint>
#include <span>
#include <vector>

#include "core/mesh/column.h"
#include "core/mesh/mesh.h"
#include "core/model/triangle_tree.h"

namespace aomd {

/// The faces of a triangle mesh, found by boxes. A face that changes keeps its place in the tree,
/// and the boxes above it follow; operations are local, so that the places stay good. Once half of
/// the faces are gone, the tree is built anew: faces of any sizes mix, and they grow as a
/// decimation goes on.
class FaceTree {
 public:
  /// A face, its corners and their box; the box of one that is gone or has no area is empty.
  struct Item {
    Box box;
    Triangle corners;
    Face face;
  };

  /// O(n log n); about 160 bytes a face. T(2,0) must be stored, and all faces be triangles.
  explicit FaceTree(const Mesh& mesh);

  [[nodiscard]] const Item& item(Face f) const { return items_[place_[f]]; }
  /// Takes a face out; it keeps its place. O(log n).
  void remove(Face f);
  /// Puts new corners in a face's place. O(log n), but for building anew.
  void put(Face f, const Triangle& corners);
  /// Builds anew where that pays.
  void tidy();

  /// Calls visit(item) for every face whose box touches.
  template <typename Visit>
  void touching(const Box& box, Visit&& visit) const;

 private:
  struct Node {
    Box box;
    std::uint32_t begin = 0, end = 0;  ///< items below it
    std::uint32_t right = 0;           ///< 0: a leaf; else the left child follows at once
    std::uint32_t parent = no_index;
  };
  static constexpr std::uint32_t leaf_size = 4, depth = 40;  // halves each time: below 32

  void put(Face f, const Box& box);
  void build();
  void build(std::uint32_t begin, std::uint32_t end, std::uint32_t parent);
  void refit(std::uint32_t id);
  [[nodiscard]] Box box_below(std::uint32_t id) const;

  std::vector<Item> items_;
  std::vector<Node> nodes_;
  Column<Face, std::uint32_t> place_;
  std::vector<std::uint32_t> leaf_;  ///< by place
  std::size_t present_ = 0;
};

template <typename Visit>
void FaceTree::touching(const Box& box, Visit&& visit) const {
  if (nodes_.empty()) return;
  std::uint32_t stack[depth];
  std::size_t top = 0;
  stack[top++] = 0;
  while (top > 0) {
    const std::uint32_t id = stack[--top];
    const Node& node = nodes_[id];
    if (!node.box.touches(box)) continue;
    if (node.right != 0) {
      stack[top++] = node.right;
      stack[top++] = id + 1;
      continue;
    }
    for (std::uint32_t n = node.begin; n < node.end; ++n)
      if (items_[n].box.touches(box)) visit(items_[n]);
  }
}

}  // namespace aomd
