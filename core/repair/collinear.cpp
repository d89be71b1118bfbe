#include <cmath>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "core/mesh/geometry.h"
#include "core/repair/stages.h"

namespace aomd::repair_detail {

bool collinear(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  if (!is_flat(a, b, c, area_normal(a, b, c))) return false;  // far from any doubt
  const glm::dvec3 sum = a + b + c;
  if (!std::isfinite(sum.x + sum.y + sum.z)) return false;
  const auto exact = [](const glm::dvec3& p) { return Kernel::Point_3(p.x, p.y, p.z); };
  return CGAL::collinear(exact(a), exact(b), exact(c));
}

}  // namespace aomd::repair_detail
