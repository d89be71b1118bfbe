#include "core/model/triangle_intersection.h"

#include <algorithm>
#include <cmath>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Segment_3.h>
#include <CGAL/Triangle_3.h>
#include <CGAL/intersections.h>
#include <glm/geometric.hpp>

namespace aomd {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using glm::dvec3;

double largest_of(const dvec3& p) {
  return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
}

/// Points for the exact predicates, in multiples of a power of two near the largest coordinate of
/// those that are looked at together: then neither doubles nor intervals of them overflow. What is
/// smaller by more than 60 decades counts as 0, since exact numbers that far apart take
/// milliseconds to compare.
class Exact {
 public:
  template <typename... Corners>
  explicit Exact(const Corners&... corners) {
    double largest = 0;
    for (const auto* points : {&corners...})
      for (const dvec3& p : *points) largest = std::max(largest, largest_of(p));
    std::frexp(largest, &exponent_);
  }
  [[nodiscard]] Kernel::Point_3 operator()(const dvec3& p) const {
    return {scaled(p.x), scaled(p.y), scaled(p.z)};
  }
  [[nodiscard]] Kernel::Triangle_3 operator()(const Triangle& t) const {
    return {(*this)(t[0]), (*this)(t[1]), (*this)(t[2])};
  }

 private:
  [[nodiscard]] double scaled(double x) const {
    const double y = std::ldexp(x, -exponent_);
    return std::abs(y) < 0x1p-200 ? 0.0 : y;
  }
  int exponent_ = 0;
};

// What has no extent left beside something far larger meets nothing.
template <typename Other>
bool meet(const Kernel::Triangle_3& t, const Other& other) {
  return !t.is_degenerate() && !other.is_degenerate() && CGAL::do_intersect(t, other);
}

// The sign of direction . (p - origin) as far as rounding allows: -1, +1, or 0 for "cannot tell".
// The direction is taken as it is, so that any direction found in doubles is as good as an exact
// one. Three differences, three products and two sums lose less than 6 units in the last place of
// the sum of sizes.
int side(const dvec3& direction, const dvec3& origin, const dvec3& p) {
  constexpr double bound = 8 * 1.2e-16;
  const dvec3 terms = direction * (p - origin);
  const double sum = terms.x + terms.y + terms.z;
  const double doubt = bound * (std::abs(terms.x) + std::abs(terms.y) + std::abs(terms.z)) + 1e-290;
  return sum > doubt ? 1 : sum < -doubt ? -1 : 0;
}

// The sign of the volume of (a, b, c, d), or 0 for "cannot tell" (bound after Shewchuk 1997,
// rounded up).
int orientation(const dvec3& a, const dvec3& b, const dvec3& c, const dvec3& d) {
  const dvec3 u = b - a, v = c - a, w = d - a;
  const dvec3 s(std::abs(u.x), std::abs(u.y), std::abs(u.z)),
      r(std::abs(v.x), std::abs(v.y), std::abs(v.z)),
      q(std::abs(w.x), std::abs(w.y), std::abs(w.z));
  const double size =
      q.x * (s.y * r.z + s.z * r.y) + q.y * (s.z * r.x + s.x * r.z) + q.z * (s.x * r.y + s.y * r.x);
  const double volume = glm::dot(glm::cross(u, v), w), doubt = 1.2e-15 * size + 1e-290;
  return volume > doubt ? 1 : volume < -doubt ? -1 : 0;
}

// Whether all three corners of t lie strictly on one side of the plane of s.
bool on_one_side(const Triangle& s, const Triangle& t) {
  const int first = orientation(s[0], s[1], s[2], t[0]);
  return first != 0 && orientation(s[0], s[1], s[2], t[1]) == first &&
         orientation(s[0], s[1], s[2], t[2]) == first;
}

// A plane with all of s strictly below and all of t strictly above some level: found by trying, so
// that "no" means "do not know".
bool parted_along(const dvec3& direction, const Triangle& s, const Triangle& t) {
  const dvec3& origin = s[0];
  double low[2] = {0, 0}, high[2] = {0, 0}, doubt = 1e-290;
  for (int which = 0; which < 2; ++which) {
    for (int k = 0; k < 3; ++k) {
      const dvec3 terms = direction * ((which ? t : s)[static_cast<std::size_t>(k)] - origin);
      const double at = terms.x + terms.y + terms.z;
      low[which] = k ? std::min(low[which], at) : at;
      high[which] = k ? std::max(high[which], at) : at;
      doubt = std::max(doubt, std::abs(terms.x) + std::abs(terms.y) + std::abs(terms.z));
    }
  }
  doubt *= 2e-15;
  return high[0] + doubt < low[1] || high[1] + doubt < low[0];
}

bool apart(const Triangle& s, const Triangle& t) {
  if (on_one_side(s, t) || on_one_side(t, s)) return true;
  const dvec3 n = glm::cross(s[1] - s[0], s[2] - s[0]), m = glm::cross(t[1] - t[0], t[2] - t[0]);
  for (std::size_t k = 0; k < 3; ++k) {
    if (parted_along(glm::cross(n, s[(k + 1) % 3] - s[k]), s, t)) return true;
    if (parted_along(glm::cross(m, t[(k + 1) % 3] - t[k]), s, t)) return true;
  }
  return false;
}

bool cross_nowhere_shared(const Triangle& s, const Triangle& t) {
  if (apart(s, t)) return false;
  const Exact exact(s, t);
  return meet(exact(s), exact(t));
}

// Two triangles around a common corner v, seen from it as two sectors: do they meet only in v? A
// plane through v between the sectors proves it; bisectors of one side of each are tried. "No"
// means "do not know".
bool sectors_apart(const dvec3& v, const std::array<dvec3, 2>& s, const std::array<dvec3, 2>& t) {
  const auto splits = [&](const dvec3& direction) {
    return side(direction, v, s[0]) > 0 && side(direction, v, s[1]) > 0 &&
           side(direction, v, t[0]) < 0 && side(direction, v, t[1]) < 0;
  };
  if (splits(s[0] + s[1] - t[0] - t[1]))
    return true;  // enough where sides are about as long: no roots
  const dvec3 a = glm::normalize(s[0] - v), b = glm::normalize(s[1] - v);
  const dvec3 c = glm::normalize(t[0] - v), d = glm::normalize(t[1] - v);
  return splits(a + b - c - d) || splits(a - c) || splits(a - d) || splits(b - c) || splits(b - d);
}

bool cross_at_vertex(const Triangle& s, std::size_t i, const Triangle& t, std::size_t j) {
  const dvec3 &v = s[i], &s1 = s[(i + 1) % 3], &s2 = s[(i + 2) % 3], &t1 = t[(j + 1) % 3],
              &t2 = t[(j + 2) % 3];
  if (sectors_apart(v, {s1, s2}, {t1, t2})) return false;
  const int a = orientation(s[0], s[1], s[2], t1), b = orientation(s[0], s[1], s[2], t2);
  if (a != 0 && a == b) return false;
  const int c = orientation(t[0], t[1], t[2], s1), d = orientation(t[0], t[1], t[2], s2);
  if (c != 0 && c == d) return false;
  const Exact exact(s, t);
  return meet(exact(s), Kernel::Segment_3(exact(t1), exact(t2))) ||
         meet(exact(t), Kernel::Segment_3(exact(s1), exact(s2)));
}

// p and q on different sides of the line through e0 and e1, as seen along an axis: then the
// triangles, should they lie in one plane, lie beside each other in it.
bool unfolded(const dvec3& e0, const dvec3& e1, const dvec3& p, const dvec3& q) {
  const dvec3 e = e1 - e0, n = glm::cross(e, p - e0),
              size(std::abs(n.x), std::abs(n.y), std::abs(n.z));
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  const auto turn = [&](const dvec3& r) {
    const double left = e[i] * (r[j] - e0[j]), right = e[j] * (r[i] - e0[i]);
    const double doubt = 1e-15 * (std::abs(left) + std::abs(right)) + 1e-290;
    return left - right > doubt ? 1 : right - left > doubt ? -1 : 0;
  };
  return turn(p) * turn(q) < 0;
}

bool fold_at_edge(const dvec3& e0, const dvec3& e1, const dvec3& p, const dvec3& q) {
  if (unfolded(e0, e1, p, q) || orientation(e0, e1, p, q) != 0) return false;
  const Exact exact(std::array{e0, e1, p, q});
  const auto a = exact(e0), b = exact(e1), c = exact(p), d = exact(q);
  return CGAL::coplanar(a, b, c, d) && CGAL::coplanar_orientation(a, b, c, d) == CGAL::POSITIVE;
}

}  // namespace

bool without_area(const Triangle& t) {
  const dvec3 u = t[1] - t[0], v = t[2] - t[0], n = glm::cross(u, v);
  const double sizes = glm::dot(u, u) * glm::dot(v, v);
  if (glm::dot(n, n) > 1e-24 * sizes && sizes > 1e-200) return false;
  const Exact exact(t);
  return CGAL::collinear(exact(t[0]), exact(t[1]), exact(t[2]));
}

bool intersect(const Triangle& s, const Triangle& t) {
  std::size_t shared = 0, is[3], it[3];
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      if (s[i] == t[j]) {
        is[shared] = i;
        it[shared++] = j;
        break;
      }
  switch (shared) {
    case 0:
      return cross_nowhere_shared(s, t);
    case 1:
      return cross_at_vertex(s, is[0], t, it[0]);
    case 2:
      return fold_at_edge(s[is[0]], s[is[1]], s[3 - is[0] - is[1]], t[3 - it[0] - it[1]]);
    default:
      return true;
  }
}

}  // namespace aomd
