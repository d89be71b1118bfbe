#pragma once
// Triangles over a triangle: whether they are all over it, and how high.

#include <array>
#include <cstddef>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/model/triangle_tree.h"

namespace aomd {

/// Triangles laid over another one along its normal, as the faces of a surface that passes over or
/// below it at some height, within reach. Heights are linear over each, so that those at the
/// corners of what they have in common bound all.
class Overlay {
 public:
  Overlay(const Triangle& below, double reach2);

  /// The largest squared height of what `t` has over the triangle; negative where that is nothing,
  /// or out of reach: then it counts for nothing. About 50 ns.
  double lay(const Triangle& t);
  /// What was laid is over all of the triangle, once: as areas tell, up to rounding. Never so for a
  /// triangle without area.
  [[nodiscard]] bool complete() const;

 private:
  /// Of a convex one there are at most 6; rounding may put those of slivers in zigzag across a
  /// side, and a clip adds at most half of them then: 3, 4, 6, 9.
  static constexpr std::size_t most_corners = 9;
  /// What `t` and the triangle have in common, in the frame: (along, across, height).
  struct Polygon {
    std::array<glm::dvec3, most_corners> corners;
    std::size_t size = 0;
  };
  [[nodiscard]] glm::dvec3 in_frame(const glm::dvec3& p) const;
  void clip(std::size_t side, Polygon& polygon) const;

  glm::dvec3 origin_, along_{0.0}, across_{0.0}, normal_{0.0};
  std::array<glm::dvec2, 3> corners_{};
  double reach2_;
  double area2_ = 0, laid2_ = 0;  ///< twice the areas
};

}  // namespace aomd
