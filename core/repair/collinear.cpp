#include <cmath>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "core/mesh/geometry.h"
#include "core/repair/stages.h"

namespace aomd::repair_detail {
namespace {

bool differ_along_one_axis(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const auto differ = [&](int axis) { return a[axis] != b[axis] || b[axis] != c[axis]; };
  return int{differ(0)} + int{differ(1)} + int{differ(2)} <= 1;
}

}  // namespace

bool collinear(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  if (!is_flat(a, b, c, area_normal(a, b, c))) return false;  // far from any doubt
  const glm::dvec3 sum = a + b + c;
  if (!std::isfinite(sum.x + sum.y + sum.z)) return false;
  if (a == b || b == c || c == a || differ_along_one_axis(a, b, c)) return true;
  const auto exact = [](const glm::dvec3& p) { return Kernel::Point_3(p.x, p.y, p.z); };
  return CGAL::collinear(exact(a), exact(b), exact(c));
}

}  // namespace aomd::repair_detail
