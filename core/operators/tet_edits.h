#pragma once
// What the operators that replace tetrahedra by others on the same vertices share.

#include <algorithm>
#include <array>
#include <cstdint>

#include "core/mesh/mesh.h"
#include "core/mesh/tet_geometry.h"

namespace aomd {

/// Whether a worst shape (tet_shape) is worth an edit: better than the one before by more than what
/// could swap back and forth, and upright beyond doubt.
[[nodiscard]] inline bool is_better_shape(double before, double after) {
  constexpr double smallest_gain = 1e-6;
  return after > std::max(before, 0.0) + smallest_gain;
}

/// What an operator that replaces tetrahedra is after.
enum class RemovalGoal : std::uint8_t {
  Worst,  ///< the worst tet_shape is to become better
  Sum     ///< the sum of tet_energy is to become less
};

/// How good some tetrahedra are together, by a goal: more is better.
class RemovalValue {
 public:
  explicit RemovalValue(RemovalGoal goal) : sums_(goal == RemovalGoal::Sum) {}

  /// Of no tetrahedra.
  [[nodiscard]] double none() const { return sums_ ? 0 : 2; }
  [[nodiscard]] double of(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                          const glm::dvec3& d) const {
    return sums_ ? -tet_energy(a, b, c, d) : tet_shape(a, b, c, d);
  }
  [[nodiscard]] double both(double x, double y) const { return sums_ ? x + y : std::min(x, y); }
  /// By more than what could swap back and forth; with all upright that come to be.
  [[nodiscard]] bool is_better(double before, double after) const {
    constexpr double smallest_part = 1e-6;
    return sums_ ? after > (1 - smallest_part) * before : is_better_shape(before, after);
  }

 private:
  bool sums_;
};

/// Where a vertex stands among others that have it.
template <std::size_t N>
[[nodiscard]] std::uint32_t slot_in(const std::array<Vertex, N>& vertices, Vertex v) {
  return static_cast<std::uint32_t>(std::find(vertices.begin(), vertices.end(), v) -
                                    vertices.begin());
}

/// A new edge inside a region with the faces between it and other vertices, where levels are
/// complete: what regions need before they are rebound to it.
template <std::size_t N>
void create_spoke(Mesh& mesh, Vertex a, Vertex b, const std::array<Vertex, N>& around,
                  ModelRef model) {
  if (mesh.complete(1)) mesh.create_edge(a, b, model);
  if (!mesh.complete(2)) return;
  for (const Vertex v : around) {
    const std::array corners{a, b, v};
    mesh.create_face(corners, model);
  }
}

}  // namespace aomd
