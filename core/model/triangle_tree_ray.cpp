// What a ray meets first.

#include <utility>

#include <glm/geometric.hpp>

#include "core/model/triangle_tree.h"

namespace aomd {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

/// Where a ray enters a box, or infinity. Divisions by zero give infinities, as the comparisons
/// want them.
double entry(const Box& box, const glm::dvec3& origin, const glm::dvec3& inverse) {
  double near = 0, far = unlimited;
  for (int k = 0; k < 3; ++k) {
    double a = (box.low[k] - origin[k]) * inverse[k], b = (box.high[k] - origin[k]) * inverse[k];
    if (a > b) std::swap(a, b);
    if (a > near) near = a;  // false for not-a-number: a ray within a side of the box
    if (b < far) far = b;
  }
  constexpr double slack = 1 + 1e-12;  // a flat box is met at one place
  return near <= far * slack ? near : unlimited;
}

}  // namespace

double distance_along(const glm::dvec3& origin, const glm::dvec3& direction, const Triangle& t) {
  const glm::dvec3 ab = t[1] - t[0], ac = t[2] - t[0], across = glm::cross(direction, ac);
  const double volume = glm::dot(ab, across);
  if (volume == 0) return unlimited;
  const glm::dvec3 from = (origin - t[0]) / volume, turned = glm::cross(from, ab);
  const double y = glm::dot(from, across), z = glm::dot(direction, turned);
  const double distance = glm::dot(ac, turned);
  return y >= 0 && z >= 0 && y + z <= 1 && distance >= 0 ? distance : unlimited;
}

TriangleTree::RayHit TriangleTree::first_along(
    const glm::dvec3& origin, const glm::dvec3& direction,
    const std::function<bool(std::uint32_t)>& takes) const {
  RayHit best;
  const glm::dvec3 inverse = 1.0 / direction;
  boxes_.cheapest(
      best.distance,
      [&](std::uint32_t node) { return entry(boxes_.node(node).box, origin, inverse); },
      [&](std::uint32_t n) {
        if (const double d = distance_along(origin, direction, triangles_[n]);
            d < best.distance && takes(n))
          best = {n, d};
        return best.distance;
      });
  return best;
}

}  // namespace aomd
