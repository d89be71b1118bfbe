#include "core/decimate/guard/triangle_cuts.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace aomd {
namespace {

using glm::dvec3;

double length2_of(const dvec3& v) { return glm::dot(v, v); }

// The side that starts at the returned corner is the longest.
std::size_t longest_side(const Triangle& t) {
  const double a = length2_of(t[1] - t[0]), b = length2_of(t[2] - t[1]),
               c = length2_of(t[0] - t[2]);
  return a >= b && a >= c ? 0 : b >= c ? 1 : 2;
}

// By a plane, given how far the corners lie beyond it: one corner lies alone on its side. What is
// beyond comes first.
TriangleParts cut(const Triangle& t, const dvec3& beyond) {
  const auto over = [&](std::size_t i) { return beyond[static_cast<int>(i)] > 0; };
  const std::size_t a = over(1) == over(2)   ? 0
                        : over(0) == over(2) ? 1
                                             : 2,
                    b = (a + 1) % 3, c = (a + 2) % 3;
  const auto crossing = [&](std::size_t i, std::size_t j) {
    const double from = beyond[static_cast<int>(i)], to = beyond[static_cast<int>(j)];
    return t[i] + (from / (from - to)) * (t[j] - t[i]);
  };
  const dvec3 ab = crossing(a, b), ac = crossing(a, c);
  const Triangle alone{t[a], ab, ac}, first{ab, t[b], t[c]}, second{ab, t[c], ac};
  if (over(a)) return {{alone, first, second}, 3};
  return {{first, second, alone}, 3};
}

}  // namespace

double longest_side2(const Triangle& t) {
  const std::size_t k = longest_side(t);
  return length2_of(t[(k + 1) % 3] - t[k]);
}

TriangleParts bisected(const Triangle& t) {
  const std::size_t k = longest_side(t), l = (k + 1) % 3, m = (k + 2) % 3;
  const dvec3 middle = 0.5 * (t[k] + t[l]);
  return {{Triangle{middle, t[l], t[m]}, Triangle{t[k], middle, t[m]}}, 2};
}

TriangleParts cut_along_sides(const Triangle& t, const Triangle& one, double out, double least) {
  const dvec3 normal = glm::cross(one[1] - one[0], one[2] - one[0]);
  double most = least;
  dvec3 beyond(0.0);
  for (std::size_t k = 0; k < 3; ++k) {
    dvec3 outward = glm::cross(one[(k + 1) % 3] - one[k], normal);
    const double length2 = length2_of(outward);
    if (!(length2 > 0)) return {};
    outward /= std::sqrt(length2);
    dvec3 over(0.0);
    for (int i = 0; i < 3; ++i)
      over[i] = glm::dot(outward, t[static_cast<std::size_t>(i)] - one[k]) - out;
    const double high = std::max({over.x, over.y, over.z}),
                 low = std::min({over.x, over.y, over.z});
    if (high <= most || low >= -least) continue;
    most = high;
    beyond = over;
  }
  return most > least ? cut(t, beyond) : TriangleParts();
}

}  // namespace aomd
