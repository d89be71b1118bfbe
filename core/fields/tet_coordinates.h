#pragma once
// Barycentric coordinates of a tetrahedron, and how much of another one lies inside.

#include <array>
#include <cstddef>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace aomd::fields {

/// The corners of a tetrahedron.
using Tet = std::array<glm::dvec3, 4>;
/// One number for each corner; they add up to 1.
using Weights = std::array<double, 4>;

/// The affine map from points to barycentric coordinates.
class TetCoordinates {
 public:
  explicit TetCoordinates(const Tet& corners);

  /// True where the tetrahedron has no volume, or one that numbers do not tell from none: it has no
  /// coordinates then.
  [[nodiscard]] bool flat() const { return flat_; }
  [[nodiscard]] Weights at(const glm::dvec3& p) const;
  /// One of them alone, of corner 1, 2 or 3.
  [[nodiscard]] double at(const glm::dvec3& p, std::size_t corner) const {
    return glm::dot(gradients_[corner - 1], p - origin_);
  }
  /// The same with what rounding left of the way to `p` shared out twice more, so that the corners
  /// with these weights meet `p` to rounding in thin tetrahedra too.
  [[nodiscard]] Weights refined(const glm::dvec3& p) const;

 private:
  [[nodiscard]] glm::dvec3 shares(const glm::dvec3& way) const;

  glm::dvec3 origin_;
  std::array<glm::dvec3, 3> edges_, gradients_;
  bool flat_;
};

/// The least of the four: 0 or more inside.
[[nodiscard]] double least(const Weights& weights);

/// Which share of the volume of `tet` lies inside, from 0 to 1. Exact but for rounding: the corners
/// are cut by the four sides one after the other, in barycentric coordinates, where the share of a
/// piece is a product of the places of its cuts (as A. Powell and T. Abel, An exact general
/// remeshing scheme, J. Comput. Phys. 297, 2015, cut with planes).
[[nodiscard]] double share_inside(const TetCoordinates& inside, const Tet& tet);

}  // namespace aomd::fields
