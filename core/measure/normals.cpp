#include "core/measure/normals.h"

#include <algorithm>
#include <cmath>

#include "core/mesh/geometry.h"

namespace aomd::measure {
namespace {

// Faces that share the nearest point are equally near, up to rounding of about this part of the size.
constexpr double equally_near = 1e-9;

const double cosine_10deg = std::cos(10 * M_PI / 180), cosine_60deg = 0.5;

glm::dvec3 normal(const Triangle& t) { return area_normal(t[0], t[1], t[2]); }

// The cosine of the angle between a normal and a triangle of the original; the greatest angle for a triangle
// without area, so that it never counts as the one that agrees.
double agreement(const glm::dvec3& own, const Triangle& t) {
  const glm::dvec3 other = normal(t);
  return glm::dot(other, other) > 0 ? cosine_between(own, other) : -1;
}

}  // namespace

NormalDeviation measure_normals(const TriangleTree& original, const Mesh& result) {
  const double near2 = equally_near * equally_near * original.diagonal2();
  NormalDeviation deviation;
  std::uint32_t hint = no_index;
  for (const Triangle& t : triangles_of(result).corners) {
    ++deviation.triangles;
    const glm::dvec3 own = normal(t);
    if (!(glm::dot(own, own) > 0)) continue;
    const auto nearest = original.nearest((t[0] + t[1] + t[2]) / 3.0, hint);
    if (nearest.triangle == no_index) continue;
    hint = nearest.triangle;
    double best = agreement(own, original.triangle(hint));
    if (best < cosine_10deg)
      original.within(nearest.point, near2,
                      [&](std::uint32_t n) { best = std::max(best, agreement(own, original.triangle(n))); });
    deviation.above_10deg += best < cosine_10deg;
    deviation.above_60deg += best < cosine_60deg;
    deviation.flips += best < 0;
  }
  return deviation;
}

}  // namespace aomd::measure
