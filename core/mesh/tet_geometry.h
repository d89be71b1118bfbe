#pragma once
// Small geometry of tetrahedra that the operators share. A tetrahedron (a, b, c, d) stands upright
// where d lies on the side to which the normal of (a, b, c) points.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#pragma GCC visibility push(default)

namespace aomd {

/// Six times the signed volume: positive where the tetrahedron stands upright.
[[nodiscard]] inline double six_volumes(const glm::dvec3& a, const glm::dvec3& b,
                                        const glm::dvec3& c, const glm::dvec3& d) {
  return glm::dot(glm::cross(b - a, c - a), d - a);
}

/// The sum of the six squared edge lengths.
[[nodiscard]] inline double squared_edges(const glm::dvec3& a, const glm::dvec3& b,
                                          const glm::dvec3& c, const glm::dvec3& d) {
  const auto square = [](const glm::dvec3& v) { return glm::dot(v, v); };
  return square(b - a) + square(c - a) + square(d - a) + square(c - b) + square(d - b) +
         square(d - c);
}

/// The shape of a tetrahedron (Parthasarathy, Graichen, Hathaway 1994): 6 sqrt(2) V / l^3, where l
/// is the root mean square of the edge lengths. 1 for the regular one, 0 for a flat one, negative
/// for one that is inside out.
[[nodiscard]] inline double tet_shape(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                                      const glm::dvec3& d) {
  const double mean_square = squared_edges(a, b, c, d) / 6;
  return mean_square > 0 ? std::numbers::sqrt2 * six_volumes(a, b, c, d) /
                               (mean_square * std::sqrt(mean_square))
                         : 0;
}

/// True where the volume is positive beyond doubt: the computed one exceeds what rounding of the
/// coordinates' differences may make of none.
[[nodiscard]] inline bool is_upright(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                                     const glm::dvec3& d) {
  const double size = squared_edges(a, b, c, d);
  return six_volumes(a, b, c, d) > 1e-13 * size * std::sqrt(size);
}

/// What a shape is worth where many are summed: tet_shape to the power of -2, so 1 for the regular
/// tetrahedron and the more the flatter; infinite where it is not upright. Convex in the place of a
/// vertex as long as all around it stand upright (Munson 2007).
[[nodiscard]] inline double tet_energy(const glm::dvec3& a, const glm::dvec3& b,
                                       const glm::dvec3& c, const glm::dvec3& d) {
  if (!is_upright(a, b, c, d)) return std::numeric_limits<double>::infinity();
  const double mean_square = squared_edges(a, b, c, d) / 6, volumes = six_volumes(a, b, c, d);
  return mean_square * mean_square * mean_square / (2 * volumes * volumes);
}

/// The cosine of the smallest dihedral angle (so larger is worse); 1 where a face has no area.
[[nodiscard]] inline double smallest_dihedral_cosine(const glm::dvec3& a, const glm::dvec3& b,
                                                     const glm::dvec3& c, const glm::dvec3& d) {
  const std::array<glm::dvec3, 4> outward{glm::cross(c - b, d - b), glm::cross(d - a, c - a),
                                          glm::cross(b - a, d - a), glm::cross(c - a, b - a)};
  double worst = -1;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = i + 1; k < 4; ++k) {
      const double lengths =
          std::sqrt(glm::dot(outward[i], outward[i])) * std::sqrt(glm::dot(outward[k], outward[k]));
      if (!(lengths > 0)) return 1;
      worst = std::max(worst, -glm::dot(outward[i], outward[k]) / lengths);
    }
  return std::min(worst, 1.0);
}

}  // namespace aomd

#pragma GCC visibility pop
