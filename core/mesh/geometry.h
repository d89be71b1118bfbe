#pragma once
// Small geometry that the operators share: normals compared without square roots, angles of
// triangles. Number is double, or LanesOf<double> for several triangles at once.

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "core/base/lanes.h"
#include "core/mesh/mesh.h"

#pragma GCC visibility push(default)

namespace aomd {

/// Normal of a triangle, its length twice the area.
template <typename Number>
[[nodiscard]] glm::vec<3, Number> area_normal(const glm::vec<3, Number>& a,
                                              const glm::vec<3, Number>& b,
                                              const glm::vec<3, Number>& c) {
  return glm::cross(b - a, c - a);
}

/// A limit on how far a normal may turn.
class TurnLimit {
 public:
  explicit TurnLimit(double angle_deg);
  [[nodiscard]] double angle_deg() const { return angle_deg_; }
  /// True when the angle between two normals of any lengths is at most the limit. A zero normal
  /// never passes.
  template <typename Number>
  [[nodiscard]] auto allows(const glm::vec<3, Number>& before,
                            const glm::vec<3, Number>& after) const {
    const Number zero(0.0), dot = glm::dot(before, after);
    const Number bound = Number(square_) * glm::dot(before, before) * glm::dot(after, after);
    return cosine_ >= 0 ? (dot > zero) & (dot * dot >= bound)
                        : (dot > zero) | ((bound > zero) & (dot * dot <= bound));
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
  /// True when a smallest angle with this cosine is at least the limit.
  template <typename Number>
  [[nodiscard]] auto holds_for(const Number& cosine) const {
    return cosine <= Number(cosine_);
  }
  /// The same, or where it is no smaller than the one whose cosine `before` is called for.
  template <typename Before>
  [[nodiscard]] bool allows(double now, Before&& before) const {
    return holds_for(now) || now <= before();
  }

 private:
  double angle_deg_, cosine_;
};

/// The cosine of the angle between two vectors; 0 where one has no length.
[[nodiscard]] double cosine_between(const glm::dvec3& a, const glm::dvec3& b);

/// True when a triangle has an area worth the name: an area normal longer than 1e-12 of its squared
/// sides at `a`.
template <typename Number>
[[nodiscard]] auto has_area(const glm::vec<3, Number>& a, const glm::vec<3, Number>& b,
                            const glm::vec<3, Number>& c, const glm::vec<3, Number>& normal) {
  const glm::vec<3, Number> u = b - a, v = c - a;
  const Number size = glm::dot(u, u) + glm::dot(v, v);
  return glm::dot(normal, normal) > Number(1e-24) * size * size;
}
[[nodiscard]] inline bool is_flat(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                                  const glm::dvec3& normal) {
  return !has_area(a, b, c, normal);
}

/// Cosine of the smallest angle of a triangle (so larger is worse); 1 for one without area. It lies
/// opposite the shortest side, and the law of cosines gives it from the squared sides alone.
template <typename Number>
[[nodiscard]] Number smallest_angle_cosine(const glm::vec<3, Number>& a,
                                           const glm::vec<3, Number>& b,
                                           const glm::vec<3, Number>& c) {
  using std::sqrt;
  const glm::vec<3, Number> u = b - a, v = c - b, w = a - c;
  const Number x = glm::dot(u, u), y = glm::dot(v, v), z = glm::dot(w, w);
  const Number low = select(x > y, y, x), high = select(x > y, x, y);
  const Number least = select(low > z, z, low), other = select(low > z, low, z);
  const Number cosine = (high + other - least) / (Number(2.0) * sqrt(high * other));
  return select(least > Number(0.0), cosine, Number(1.0));
}

/// Smallest angle of a triangle in degrees.
[[nodiscard]] double smallest_angle_deg(const glm::dvec3& a, const glm::dvec3& b,
                                        const glm::dvec3& c);

}  // namespace aomd

#pragma GCC visibility pop
