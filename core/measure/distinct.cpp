#include "core/measure/distinct.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "core/measure/crowded_pairs.h"

namespace aomd::measure {
namespace {

bool before(const glm::dvec3& p, const glm::dvec3& q) {
  return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
}

// From its first corner in the order of the coordinates on.
Triangle turned(Triangle t) {
  std::rotate(t.begin(), std::min_element(t.begin(), t.end(), before), t.end());
  return t;
}

bool triangle_before(const Triangle& s, const Triangle& t) {
  return std::lexicographical_compare(s.begin(), s.end(), t.begin(), t.end(), before);
}

}  // namespace

DistinctTriangles distinct(std::vector<Triangle> triangles) {
  if (!crowded(triangles)) return {std::move(triangles), {}};
  std::vector<Triangle> keys;
  keys.reserve(triangles.size());
  for (const Triangle& t : triangles) keys.push_back(turned(t));
  std::vector<std::uint32_t> order(triangles.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    return triangle_before(keys[i], keys[j]);
  });
  std::vector<std::uint32_t> copies(triangles.size(), 0);  // of those that stay
  for (std::size_t i = 0, first = 0; i < order.size(); ++i) {
    if (triangle_before(keys[order[first]], keys[order[i]])) first = i;
    ++copies[order[first]];
  }
  DistinctTriangles result;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (copies[i] == 0) continue;
    result.triangles.push_back(triangles[i]);
    result.copies.push_back(copies[i]);
  }
  return result;
}

}  // namespace aomd::measure
