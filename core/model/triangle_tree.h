#pragma once
// A tree of boxes over triangles: which boxes touch, and which triangle is nearest to a point.

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "core/base/box.h"
#include "core/mesh/mesh.h"
#include "core/model/tilted_box.h"

namespace aomd {

/// The corners of a triangle in its own order.
using Triangle = std::array<glm::dvec3, 3>;

/// The faces of a mesh as triangles; a quad (a, b, c, d) becomes (a, b, c) and (a, c, d).
struct Triangles {
  std::vector<Triangle> corners;
  std::vector<Face> faces;  ///< the face that each is of
};

/// O(faces); the faces must hold their vertices or edges.
[[nodiscard]] Triangles triangles_of(const Mesh& mesh);
/// The same for plain arrays; the n-th of `faces` is Face(n).
[[nodiscard]] Triangles triangles_of(const MeshData& data);

/// Triangles sorted into a binary tree, split in the middle of the longest side, or at the median
/// where the middle would leave nearly all on one side; at most 4 a leaf. Built in O(n log n); the
/// triangles are copied, about 170 bytes each with the tree. Where boxes along the axes tell little
/// apart, as of thin triangles around one vertex or edge, each node has a tilted box too.
class TriangleTree {
 public:
  /// The same tree for any number of threads.
  explicit TriangleTree(std::span<const Triangle> triangles, int threads = 1);

  [[nodiscard]] std::size_t size() const { return triangles_.size(); }
  /// The n-th triangle in the tree's order, and its index in what the tree was built from.
  [[nodiscard]] const Triangle& triangle(std::uint32_t n) const { return triangles_[n]; }
  [[nodiscard]] std::uint32_t source(std::uint32_t n) const { return source_[n]; }
  /// The box around all.
  [[nodiscard]] Box box() const { return nodes_.empty() ? Box() : nodes_[0].box; }
  /// Its squared diagonal; 0 when empty.
  [[nodiscard]] double diagonal2() const;

  struct Nearest {
    std::uint32_t triangle = no_index;  ///< in the tree's order
    glm::dvec3 point{};
    double distance2 = std::numeric_limits<double>::infinity();
  };
  /// The point of all triangles that is nearest to `p`. A `hint` (a triangle likely to be near, in
  /// the tree's order) only saves time. About O(log n). Nothing (no_index) when the tree is empty.
  [[nodiscard]] Nearest nearest(const glm::dvec3& p, std::uint32_t hint = no_index) const;

  struct RayHit {
    std::uint32_t triangle = no_index;                          ///< in the tree's order
    double distance = std::numeric_limits<double>::infinity();  ///< in lengths of the direction
  };
  /// The first triangle that a ray meets, from either side, among those that takes(n) accepts
  /// (asked only where the ray meets the triangle). About O(log n). Nothing (no_index) where there
  /// is none.
  [[nodiscard]] RayHit first_along(const glm::dvec3& origin, const glm::dvec3& direction,
                                   const std::function<bool(std::uint32_t)>& takes) const;

  /// Calls visit(n) for every triangle, in the tree's order, whose squared distance to `p` is at
  /// most `distance2`.
  template <typename Visit>
  void within(const glm::dvec3& p, double distance2, Visit&& visit) const;

  /// Calls visit(n, m) once for every pair of triangles whose boxes touch.
  template <typename Visit>
  void touching_pairs(Visit&& visit) const {
    touching_pairs(0, nodes(), visit);
  }
  /// A part of them: those told apart by the nodes [begin, end) of all.
  template <typename Visit>
  void touching_pairs(std::size_t begin, std::size_t end, Visit&& visit) const;
  /// Calls visit(n, m) once for every triangle n of this tree and m of another whose boxes touch.
  template <typename Visit>
  void touching_pairs(const TriangleTree& other, Visit&& visit) const {
    if (!nodes_.empty() && !other.nodes_.empty()) pairs_between(0, other, 0, visit);
  }
  [[nodiscard]] std::size_t nodes() const { return nodes_.size(); }

 private:
  struct Node {
    Box box;
    std::uint32_t begin = 0, end = 0;  ///< triangles below it
    std::uint32_t right = 0;           ///< 0: a leaf; else the left child follows at once
    [[nodiscard]] bool leaf() const { return right == 0; }
  };
  static constexpr std::uint32_t leaf_size = 4;
  // A node keeps at most 7/8 of its parent's triangles: the depth is below log(2^32) / log(8/7),
  // 167.
  static constexpr std::size_t lopsided = 8, stack_size = 176;

  struct Item;
  static std::size_t split(std::span<Item> items);
  static void build(std::span<Item> items, std::uint32_t begin, int threads,
                    std::vector<Node>& nodes);
  void add_boxes();
  [[nodiscard]] bool boxes_overlap() const;
  void add_tilted_boxes();
  /// Squared distance that all triangles below a node have from `p` at least.
  [[nodiscard]] double bound2(std::uint32_t node, const glm::dvec3& p) const {
    const double d2 = nodes_[node].box.distance2(p);
    return tilted_.empty() ? d2 : std::max(d2, tilted_[node].distance2(p));
  }
  template <typename Visit>
  void pairs_between(std::uint32_t a, const TriangleTree& other, std::uint32_t b,
                     Visit& visit) const;

  std::vector<Node> nodes_;
  std::vector<TiltedBox> tilted_;  ///< of each node, or empty
  std::vector<Triangle> triangles_;
  std::vector<Box> boxes_;
  std::vector<std::uint32_t> source_;
};

/// Where a ray meets a triangle, from either side, in lengths of the direction; infinite where it
/// does not (Moeller and Trumbore 1997). Rims belong to the triangle.
[[nodiscard]] double distance_along(const glm::dvec3& origin, const glm::dvec3& direction,
                                    const Triangle& t);

/// The place on triangle (a, b, c) nearest to `p`, as barycentric coordinates (Ericson, Real-Time
/// Collision Detection, section 5.1.5). Returns the squared distance.
double nearest_barycentric(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b,
                           const glm::dvec3& c, glm::dvec3& at);

/// The point of a triangle nearest to `p` (Ericson, Real-Time Collision Detection, section 5.1.5).
[[nodiscard]] glm::dvec3 nearest_point(const Triangle& t, const glm::dvec3& p);

template <typename Visit>
void TriangleTree::within(const glm::dvec3& p, double distance2, Visit&& visit) const {
  if (nodes_.empty()) return;
  std::uint32_t stack[stack_size];
  std::size_t top = 0;
  stack[top++] = 0;
  while (top > 0) {
    const std::uint32_t id = stack[--top];
    const Node& node = nodes_[id];
    if (bound2(id, p) > distance2) continue;
    if (!node.leaf()) {
      stack[top++] = node.right;
      stack[top++] = id + 1;
      continue;
    }
    for (std::uint32_t n = node.begin; n < node.end; ++n) {
      const glm::dvec3 d = nearest_point(triangles_[n], p) - p;
      if (d.x * d.x + d.y * d.y + d.z * d.z <= distance2) visit(n);
    }
  }
}

template <typename Visit>
void TriangleTree::pairs_between(std::uint32_t a, const TriangleTree& other, std::uint32_t b,
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
void TriangleTree::touching_pairs(std::size_t begin, std::size_t end, Visit&& visit) const {
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
