#pragma once
// Triangles in a tree of boxes: which is nearest to a point, which a ray meets first.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "core/base/box_tree.h"
#include "core/mesh/mesh.h"
#include "core/model/tilted_box.h"

#pragma GCC visibility push(default)

namespace aomd {

/// The corners of a triangle in its own order.
using Triangle = std::array<glm::dvec3, 3>;

[[nodiscard]] inline Box box_of(const Triangle& t) {
  Box box;
  for (const glm::dvec3& p : t) box.add(p);
  return box;
}

/// The faces of a mesh as triangles; a quad (a, b, c, d) becomes (a, b, c) and (a, c, d).
struct Triangles {
  std::vector<Triangle> corners;
  std::vector<Face> faces;  ///< the face that each is of
};

/// O(faces); the faces must hold their vertices or edges.
[[nodiscard]] Triangles triangles_of(const Mesh& mesh);
/// The faces of plain arrays as triangles; the n-th of `faces` is Face(n).
[[nodiscard]] Triangles triangles_of(const MeshData& data);

/// The boxes of triangles, sorted by their centres. The same tree for any number of threads.
[[nodiscard]] BoxTree boxes_of(std::span<const Triangle> triangles, int threads = 1);

/// Triangles in a tree of boxes. Built in O(n log n); about 160 bytes a triangle. Where boxes along
/// the axes tell little apart, as of thin triangles around one vertex or edge, each node has a
/// tilted box too.
class TriangleTree {
 public:
  /// The same tree for any number of threads.
  explicit TriangleTree(std::vector<Triangle> triangles, int threads = 1);

  [[nodiscard]] std::size_t size() const { return triangles_.size(); }
  /// The n-th triangle in the tree's order, and its index in what the tree was built from.
  [[nodiscard]] const Triangle& triangle(std::uint32_t n) const { return triangles_[n]; }
  [[nodiscard]] std::uint32_t source(std::uint32_t n) const { return boxes_.source(n); }
  /// The box around all.
  [[nodiscard]] Box box() const { return boxes_.box(); }
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

  /// The same among the triangles that takes(n) accepts and whose squared distance is at most
  /// `most2`.
  template <typename Takes>
  [[nodiscard]] Nearest nearest_of(const glm::dvec3& p, const Takes& takes,
                                   double most2 = std::numeric_limits<double>::infinity(),
                                   std::uint32_t hint = no_index) const;

  struct RayHit {
    std::uint32_t triangle = no_index;                          ///< in the tree's order
    double distance = std::numeric_limits<double>::infinity();  ///< in lengths of the direction
  };
  /// The first triangle that a ray meets, from either side, among those that takes(n) accepts
  /// (asked only where the ray meets the triangle). About O(log n). Nothing (no_index) where there
  /// is none.
  [[nodiscard]] RayHit first_along(const glm::dvec3& origin, const glm::dvec3& direction,
                                   const std::function<bool(std::uint32_t)>& takes) const;

  /// Calls visit(n) for the triangles, in the tree's order, of every leaf whose box reaches(box)
  /// accepts; it must accept a box around one that it accepts.
  template <typename Reaches, typename Visit>
  void reached(const Reaches& reaches, Visit&& visit) const {
    boxes_.reached([&](std::uint32_t node) { return reaches(boxes_.node(node).box); }, visit);
  }

  /// Calls visit(n) for every triangle, in the tree's order, whose squared distance to `p` is at
  /// most `distance2`.
  template <typename Visit>
  void within(const glm::dvec3& p, double distance2, Visit&& visit) const;

 private:
  void put_in_order();
  [[nodiscard]] bool boxes_overlap() const;
  void add_tilted_boxes();
  /// Squared distance that all triangles below a node have from `p` at least.
  [[nodiscard]] double bound2(std::uint32_t node, const glm::dvec3& p) const {
    const double d2 = boxes_.node(node).box.distance2(p);
    return tilted_.empty() ? d2 : std::max(d2, tilted_[node].distance2(p));
  }

  BoxTree boxes_;
  std::vector<TiltedBox> tilted_;  ///< of each node, or empty
  std::vector<Triangle> triangles_;
};

/// Where a ray meets a triangle, from either side, in lengths of the direction; infinite where it
/// does not (Moeller and Trumbore 1997). Rims belong to the triangle.
[[nodiscard]] double distance_along(const glm::dvec3& origin, const glm::dvec3& direction,
                                    const Triangle& t);

/// The place on triangle (a, b, c) nearest to `p`, as barycentric coordinates (Ericson, Real-Time
/// Collision Detection, section 5.1.5). Returns the squared distance.
double nearest_barycentric(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b,
                           const glm::dvec3& c, glm::dvec3& barycentric);

/// The point of a triangle nearest to `p` (Ericson, Real-Time Collision Detection, section 5.1.5).
[[nodiscard]] glm::dvec3 nearest_point(const Triangle& t, const glm::dvec3& p);

// Where boxes overlap, those of thousands hold a point near what they share: one of them that it
// lies on up to rounding is enough.
template <typename Takes>
TriangleTree::Nearest TriangleTree::nearest_of(const glm::dvec3& p, const Takes& takes,
                                               double most2, std::uint32_t hint) const {
  Nearest best;
  double limit = std::nextafter(most2, std::numeric_limits<double>::infinity());
  const double as_good_as_none = tilted_.empty() ? 0 : 1e-30 * diagonal2();
  const auto consider = [&](std::uint32_t n) {
    if (takes(n)) {
      const glm::dvec3 q = nearest_point(triangles_[n], p), d = q - p;
      const double d2 = d.x * d.x + d.y * d.y + d.z * d.z;
      if (d2 < limit) best = {n, q, limit = d2};
    }
    return best.triangle == no_index || limit > as_good_as_none ? limit : 0;
  };
  const double least = hint != no_index ? consider(hint) : limit;
  boxes_.cheapest(
      least, [&](std::uint32_t node) { return bound2(node, p); }, consider);
  return best;
}

template <typename Visit>
void TriangleTree::within(const glm::dvec3& p, double distance2, Visit&& visit) const {
  boxes_.reached([&](std::uint32_t node) { return bound2(node, p) <= distance2; },
                 [&](std::uint32_t n) {
                   const glm::dvec3 d = nearest_point(triangles_[n], p) - p;
                   if (d.x * d.x + d.y * d.y + d.z * d.z <= distance2) visit(n);
                 });
}

}  // namespace aomd

#pragma GCC visibility pop
