#pragma once
// Small geometry that the operators share: normals compared without square roots, angles of
// triangles.

#include <algorithm>
#include <array>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "core/mesh/mesh.h"

#pragma GCC visibility push(default)

namespace aomd {

/// Normal of a triangle, its length twice the area.
[[nodiscard]] inline glm::dvec3 area_normal(const glm::dvec3& a, const glm::dvec3& b,
                                            const glm::dvec3& c) {
  return glm::cross(b - a, c - a);
}

/// A limit on how far a normal may turn.
class TurnLimit {
 public:
  explicit TurnLimit(double angle_deg);
  [[nodiscard]] double angle_deg() const { return angle_deg_; }
  /// True when the angle between two normals of any lengths is at most the limit. A zero normal
  /// never passes.
  [[nodiscard]] bool allows(const glm::dvec3& before, const glm::dvec3& after) const {
    const double dot = glm::dot(before, after);
    const double bound = square_ * glm::dot(before, before) * glm::dot(after, after);
    return cosine_ >= 0 ? dot > 0 && dot * dot >= bound
                        : dot > 0 || (bound > 0 && dot * dot <= bound);
  }

 private:
  double angle_deg_, cosine_, square_;
};

/// A limit on how small the smallest angle of a face may become.
class LeastAngle {
 public:
  explicit LeastAngle(double angle_deg);
  [[nodiscard]] double angle_deg() const { return angle_deg_; }
  [[nodiscard]] bool binds() const { return angle_deg_ > 0; }
  /// True when a smallest angle with the cosine `now` is at least the limit, or no smaller than the
  /// one whose cosine `before` is called for.
  template <typename Before>
  [[nodiscard]] bool allows(double now, Before&& before) const {
    return now <= cosine_ || now <= before();
  }

 private:
  double angle_deg_, cosine_;
};

/// The cosine of the angle between two vectors; 0 where one has no length.
[[nodiscard]] double cosine_between(const glm::dvec3& a, const glm::dvec3& b);

/// True when a triangle has no area worth the name: an area normal shorter than 1e-12 of its
/// squared sides at `a`.
[[nodiscard]] inline bool is_flat(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                                  const glm::dvec3& normal) {
  const glm::dvec3 u = b - a, v = c - a;
  const double size = glm::dot(u, u) + glm::dot(v, v);
  return !(glm::dot(normal, normal) > 1e-24 * size * size);
}

/// Cosine of the smallest angle of a triangle (so larger is worse); 1 for one without area.
[[nodiscard]] double smallest_angle_cosine(const glm::dvec3& a, const glm::dvec3& b,
                                           const glm::dvec3& c);

/// Smallest angle of a triangle in degrees.
[[nodiscard]] double smallest_angle_deg(const glm::dvec3& a, const glm::dvec3& b,
                                        const glm::dvec3& c);

}  // namespace aomd

#pragma GCC visibility pop
