#pragma once
// Discs over which a surface is nearly flat: what lets a large triangle be near a fine surface at
// one glance.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "core/model/triangle_tree.h"

namespace aomd {

/// A disc over which the surface stands between two heights.
//
//      ____ low + reach
//     |    |
//     |-~~-|   the surface, from low to high
//     |____|   high - reach:  what lies between has the surface within reach above or below it
struct Patch {
  glm::dvec3 centre{}, normal{};
  double radius2 = -1, bottom = 0, top = 0;
  /// In the cylinder over the disc: a convex set, so that what has its corners there lies there
  /// altogether.
  [[nodiscard]] bool contains(const glm::dvec3& p) const {
    const glm::dvec3 d = p - centre;
    const double height = glm::dot(normal, d);
    return height >= bottom && height <= top && glm::dot(d, d) - height * height <= radius2;
  }
};

/// Patches around the triangles of a surface, made when they are asked for and shared by
/// neighbours.
class Patches {
 public:
  /// `vertices` has the vertices of each triangle, in the order of what the tree was built from;
  /// none: there are no patches. O(n log n).
  Patches(const TriangleTree& tree, std::span<const std::array<std::uint32_t, 3>> vertices,
          double reach);

  /// A patch around, or close to, the n-th triangle of the tree. Every point in it has the surface
  /// within reach. Made at the first call, from 96 triangles at most: about 10 us.
  [[nodiscard]] const Patch& around(const TriangleTree& tree, std::uint32_t n);
  /// Whether around() has been made already.
  [[nodiscard]] bool known(std::uint32_t n) const { return patch_of_[n] != no_index; }

  /// From the n-th triangle over neighbours to one that is nearer to `p` than all its neighbours,
  /// and the squared distance to it: a bound from above, found without a search.
  [[nodiscard]] std::uint32_t walk(const TriangleTree& tree, const glm::dvec3& p, std::uint32_t n,
                                   double& distance2) const;

 private:
  struct Border {
    double distance2;
    std::uint32_t triangle, side;
  };
  void grow(const TriangleTree& tree, std::uint32_t seed, Patch& patch);
  [[nodiscard]] glm::dvec3 mean_normal(const TriangleTree& tree, std::uint32_t seed);
  bool add(const TriangleTree& tree, const Patch& patch, std::uint32_t n);
  void share(const TriangleTree& tree, const Patch& patch);

  double reach_;
  std::vector<std::uint32_t>
      across_;  ///< by triangle and side: the triangle behind it, or no_index
  std::vector<std::uint32_t> patch_of_;
  std::vector<Patch> patches_;
  std::vector<std::uint32_t> seen_;  ///< == stamp_ for triangles of the region
  std::uint32_t stamp_ = 0;
  std::vector<std::uint32_t> region_;
  std::vector<Border> border_;  ///< a heap: the nearest first
  double low_ = 0, high_ = 0;   ///< heights of the region
};

}  // namespace aomd
