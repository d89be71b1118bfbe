#pragma once
// Where a contraction puts the vertex that it keeps: where a quadric is least among the places at
// which no region's volume changes.

#include <array>
#include <cstddef>
#include <span>

#include <glm/vec3.hpp>

#include "core/decimate/quadric.h"
#include "core/decimate/volume/model_planes.h"
#include "core/decimate/volume/region_balance.h"

namespace aomd {

/// What a placement may do, in the units of the mesh; places count from the origin of the
/// conditions.
struct PlacementLimits {
  glm::dvec3 middle{0.0};  ///< of the edge: where flat places leave the minimum open
  double reach = 0;        ///< no further from it along a line
  double payment = 0;      ///< no further than this for the sake of debts
};

/// Directions at right angles to each other: those in which a place is fixed, then the others.
class FixedDirections {
 public:
  [[nodiscard]] int taken() const { return taken_; }
  /// The part of a vector that is not fixed.
  [[nodiscard]] glm::dvec3 free_part(glm::dvec3 n) const {
    for (int i = 0; i < taken_; ++i) n -= glm::dot(axis(i), n) * axis(i);
    return n;
  }
  /// Fixes the direction of the free part of `n`; false where there is next to none.
  bool take(const glm::dvec3& n);
  /// Fills the directions that are not fixed.
  void complete();
  [[nodiscard]] const glm::dvec3& axis(int i) const { return axes_[static_cast<std::size_t>(i)]; }

 private:
  std::array<glm::dvec3, 3> axes_{};
  int taken_ = 0;
};

/// Fixes what keeps a place on the flat model faces around it: two of them a line, three a point.
void take_planes(const ModelPlanes& planes, FixedDirections& fixed);

/// Moves `x` until the conditions hold, in directions that are not fixed yet, which they fix; at
/// most until `most` are. Conditions that say little (a normal that is short for its area) or what
/// others say already are left out: what they lack becomes a debt. The longest normals come first.
void take_conditions(std::span<const VolumeCondition> conditions, double payment, int most,
                     FixedDirections& fixed, glm::dvec3& x);

/// The place where `quadric` is least on the flat model faces around and under the conditions.
[[nodiscard]] glm::dvec3 least_under(const Quadric& quadric, const ModelPlanes& planes,
                                     std::span<const VolumeCondition> conditions,
                                     const PlacementLimits& limits);

/// The place next to `x` that does not leave these faces and meets these conditions.
[[nodiscard]] glm::dvec3 nearest_under(const ModelPlanes& planes,
                                       std::span<const VolumeCondition> conditions,
                                       const PlacementLimits& limits, const glm::dvec3& x);

/// The place on the line through `middle` along `direction` (of length 1) where the quadric is
/// least, no further than the reach.
[[nodiscard]] glm::dvec3 least_on_line(const Quadric& quadric, const glm::dvec3& direction,
                                       const PlacementLimits& limits);

}  // namespace aomd
