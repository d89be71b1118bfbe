#pragma once
// A box along axes of its own, which holds thin triangles that lie askew better than one along the
// axes of space.

#include <array>
#include <span>

#include <glm/vec3.hpp>

#include "core/base/box.h"

#pragma GCC visibility push(default)

namespace aomd {

/// What is added must lie within the box of all that it is made with: coordinates are measured from
/// the middle of that, and grown by what rounding may do to them.
class TiltedBox {
 public:
  TiltedBox() = default;
  /// Empty, along the longest side of a triangle and its normal; where these have no length, along
  /// any others.
  TiltedBox(const std::array<glm::dvec3, 3>& triangle, const Box& all);

  void add(const glm::dvec3& p);
  /// All corners of another one.
  void add(const TiltedBox& other);
  /// False only where one along the axes of space certainly has no point within `reach`: as far as
  /// its own axes tell.
  [[nodiscard]] bool may_touch(const Box& other, double reach) const;
  /// Squared distance of a point; 0 inside.
  [[nodiscard]] double distance2(const glm::dvec3& p) const { return box_.distance2(along(p)); }

 private:
  [[nodiscard]] glm::dvec3 along(const glm::dvec3& p) const {
    const glm::dvec3 q = p - middle_;
    return {glm::dot(axes_[0], q), glm::dot(axes_[1], q), glm::dot(axes_[2], q)};
  }

  std::array<glm::dvec3, 3> axes_{};
  glm::dvec3 middle_{0};
  double doubt_ = 0;
  Box box_;  ///< of coordinates along the axes
};

/// What is within reach of a few points, as a triangle's corners, told by boxes along the axes of
/// space and along its own: thin ones that lie askew have much in the first that is far off.
class Surroundings {
 public:
  /// The first three points say how it lies; all lie in `all`, and so does what is asked for.
  Surroundings(std::span<const glm::dvec3> points, const Box& all, double reach)
      : tilted_({points[0], points[1], points[2]}, all), reach_(reach) {
    for (const glm::dvec3& p : points) {
      box_.add(p);
      tilted_.add(p);
    }
    box_.low -= reach, box_.high += reach;
  }

  /// False only where a box along the axes of space certainly has nothing of it.
  [[nodiscard]] bool may_touch(const Box& other) const {
    return box_.touches(other) && tilted_.may_touch(other, reach_);
  }

 private:
  TiltedBox tilted_;
  Box box_;
  double reach_;
};

}  // namespace aomd

#pragma GCC visibility pop
