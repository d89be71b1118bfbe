#pragma once
// A tree of boxes over items of any kind: which lie in a place, which touch, which is first.

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "core/base/box.h"

#pragma GCC visibility push(default)

namespace aomd {

/// A binary tree over items that are numbered in its order, at most 4 a leaf, split in the middle
/// of the longest side, or at the median where the middle would leave nearly all on one side. It
/// knows their boxes alone: whoever owns the items keeps them in its order. About 85 bytes an item.
class BoxTree {
 public:
  /// An item before it has a number.
  struct Item {
    glm::dvec3 centre;     ///< by which it is sorted, in any unit
    std::uint32_t source;  ///< what its owner calls it
  };

  BoxTree() = default;
  /// Sorts the items; their boxes are still to be put around them (`fit`). The same tree for any
  /// number of threads. O(n log n).
  explicit BoxTree(std::span<Item> items, int threads = 1);
  /// Gives each item, in the tree's order, its box. O(n).
  void fit(std::vector<Box> boxes);
  /// Gives an item another box, and its ancestors what follows; an empty one hides it. O(log n).
  void put(std::uint32_t n, const Box& box);

  [[nodiscard]] std::size_t size() const { return source_.size(); }
  [[nodiscard]] std::size_t nodes() const { return nodes_.size(); }
  /// What the owner calls the n-th item.
  [[nodiscard]] std::uint32_t source(std::uint32_t n) const { return source_[n]; }
  [[nodiscard]] const Box& box(std::uint32_t n) const { return boxes_[n]; }
  /// The box around all.
  [[nodiscard]] Box box() const { return nodes_.empty() ? Box() : nodes_[0].box; }

  /// A node of the tree: the items [begin, end) and the box around them.
  struct Node {
    Box box;
    std::uint32_t begin = 0, end = 0;
    std::uint32_t right = 0;  ///< 0: a leaf; else the left child follows at once
    [[nodiscard]] bool leaf() const { return right == 0; }
  };
  /// Node 0 is the root; children stand after their parents.
  [[nodiscard]] const Node& node(std::uint32_t id) const { return nodes_[id]; }

  /// Calls visit(n) for the items of every leaf where reaches(node) holds; it must hold for the
  /// ancestors of a node where it does.
  template <typename Reaches, typename Visit>
  void reached(const Reaches& reaches, Visit&& visit) const;
  /// Calls visit(n) for every item whose box touches.
  template <typename Visit>
  void touching(const Box& box, Visit&& visit) const;
  /// Looks for the item that costs least: bound(node) is at most what any item below it costs, and
  /// consider(n) returns the least cost so far, which starts at `best`. Asks only where something
  /// cheaper can be, the more promising half first.
  template <typename Bound, typename Consider>
  void cheapest(double best, const Bound& bound, const Consider& consider) const;

  /// Calls visit(n, m) once for every pair of items whose boxes touch, of those told apart by the
  /// nodes [begin, end) of all.
  template <typename Visit>
  void touching_pairs(std::size_t begin, std::size_t end, Visit&& visit) const;
  /// Calls visit(n, m) once for every item n of this tree and m of another whose boxes touch.
  template <typename Visit>
  void touching_pairs(const BoxTree& other, Visit&& visit) const {
    if (!nodes_.empty() && !other.nodes_.empty()) pairs_between(0, other, 0, visit);
  }

 private:
  static constexpr std::uint32_t leaf_size = 4;
  // A node keeps at most 7/8 of its parent's items: the depth is below log(2^32) / log(8/7), 167.
  static constexpr std::size_t lopsided = 8, stack_size = 176;

  static std::size_t split(std::span<Item> items);
  static void build(std::span<Item> items, std::uint32_t begin, int threads,
                    std::vector<Node>& nodes);
  [[nodiscard]] Box box_below(std::uint32_t id) const;
  template <typename Visit>
  void pairs_between(std::uint32_t a, const BoxTree& other, std::uint32_t b, Visit& visit) const;

  std::vector<Node> nodes_;
  std::vector<Box> boxes_;
  std::vector<std::uint32_t> source_;
};

template <typename Reaches, typename Visit>
void BoxTree::reached(const Reaches& reaches, Visit&& visit) const {
  if (nodes_.empty()) return;
  std::uint32_t stack[stack_size];
  std::size_t top = 0;
  stack[top++] = 0;
  while (top > 0) {
    const std::uint32_t id = stack[--top];
    if (!reaches(id)) continue;
    const Node& node = nodes_[id];
    if (!node.leaf()) {
      stack[top++] = node.right;
      stack[top++] = id + 1;
      continue;
    }
    for (std::uint32_t n = node.begin; n < node.end; ++n) visit(n);
  }
}

template <typename Visit>
void BoxTree::touching(const Box& box, Visit&& visit) const {
  reached([&](std::uint32_t id) { return nodes_[id].box.touches(box); },
          [&](std::uint32_t n) {
            if (boxes_[n].touches(box)) visit(n);
          });
}

template <typename Bound, typename Consider>
void BoxTree::cheapest(double best, const Bound& bound, const Consider& consider) const {
  if (nodes_.empty()) return;
  struct Waiting {
    std::uint32_t node;
    double bound;
  } stack[stack_size];
  std::size_t top = 0;
  stack[top++] = {0, bound(0)};
  while (top > 0) {
    const Waiting next = stack[--top];
    if (!(next.bound < best)) continue;
    const Node& node = nodes_[next.node];
    if (node.leaf()) {
      for (std::uint32_t n = node.begin; n < node.end; ++n) best = consider(n);
      continue;
    }
    Waiting near{next.node + 1, bound(next.node + 1)}, far{node.right, bound(node.right)};
    if (far.bound < near.bound) std::swap(near, far);
    stack[top++] = far;
    stack[top++] = near;
  }
}

template <typename Visit>
void BoxTree::pairs_between(std::uint32_t a, const BoxTree& other, std::uint32_t b,
                            Visit& visit) const {
  const Node &x = nodes_[a], &y = other.nodes_[b];
  if (!x.box.touches(y.box)) return;
  if (x.leaf() && y.leaf()) {
    for (std::uint32_t n = x.begin; n < x.end; ++n) {
      if (!boxes_[n].touches(y.box)) continue;
      for (std::uint32_t m = y.begin; m < y.end; ++m)
        if (boxes_[n].touches(other.boxes_[m])) visit(n, m);
    }
  } else if (y.leaf() || (!x.leaf() && x.end - x.begin >= y.end - y.begin)) {
    pairs_between(a + 1, other, b, visit);
    pairs_between(x.right, other, b, visit);
  } else {
    pairs_between(a, other, b + 1, visit);
    pairs_between(a, other, y.right, visit);
  }
}

// Two children of one node against each other, for every node: that meets every pair once.
template <typename Visit>
void BoxTree::touching_pairs(std::size_t begin, std::size_t end, Visit&& visit) const {
  for (auto id = static_cast<std::uint32_t>(begin); id < end; ++id) {
    const Node& node = nodes_[id];
    if (!node.leaf()) {
      pairs_between(id + 1, *this, node.right, visit);
      continue;
    }
    for (std::uint32_t n = node.begin; n < node.end; ++n)
      for (std::uint32_t m = n + 1; m < node.end; ++m)
        if (boxes_[n].touches(boxes_[m])) visit(n, m);
  }
}

}  // namespace aomd

#pragma GCC visibility pop
