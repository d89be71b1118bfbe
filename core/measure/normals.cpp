#include "core/measure/normals.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/parallel.h"
#include "core/measure/distinct.h"
#include "core/mesh/geometry.h"

namespace aomd::measure {
namespace {

// Faces that share the nearest point are equally near, up to rounding of about this part of the
// size.
constexpr double equally_near = 1e-9;

const double cosine_10deg = std::cos(10 * M_PI / 180), cosine_60deg = 0.5;

glm::dvec3 normal(const Triangle& t) { return area_normal(t[0], t[1], t[2]); }

// The cosine of the angle between a normal and a triangle of the original; the greatest angle for a
// triangle without area, so that it never counts as the one that agrees.
double agreement(const glm::dvec3& own, const Triangle& t) {
  const glm::dvec3 other = normal(t);
  return glm::dot(other, other) > 0 ? cosine_between(own, other) : -1;
}

// The cosine between a triangle's normal and the original's; 1, nothing deviates, where one is
// missing. `hint` becomes the triangle of the original that was found.
double agreement_at(const TriangleTree& original, const Triangle& t, std::uint32_t& hint) {
  const double near2 = equally_near * equally_near * original.diagonal2();
  const glm::dvec3 own = normal(t);
  if (!(glm::dot(own, own) > 0)) return 1;
  const auto nearest = original.nearest((t[0] + t[1] + t[2]) / 3.0, hint);
  if (nearest.triangle == no_index) return 1;
  hint = nearest.triangle;
  double best = agreement(own, original.triangle(hint));
  if (best < cosine_10deg)
    original.within(nearest.point, near2, [&](std::uint32_t n) {
      best = std::max(best, agreement(own, original.triangle(n)));
    });
  return best;
}

}  // namespace

// Of equally near triangles the hint decides: it is forgotten at the same ones for any number of
// threads.
NormalDeviation measure_normals(const TriangleTree& original, const Mesh& result, int threads) {
  constexpr std::size_t a_hint = 256;
  const DistinctTriangles all = distinct(triangles_of(result).corners);
  const std::vector<Triangle>& triangles = all.triangles;
  std::vector<double> cosine(triangles.size());
  parallel_for((triangles.size() + a_hint - 1) / a_hint, threads, 1,
               [&](std::size_t begin, std::size_t end) {
                 std::uint32_t hint = no_index;
                 for (std::size_t i = begin * a_hint; i < std::min(end * a_hint, triangles.size());
                      ++i) {
                   if (i % a_hint == 0) hint = no_index;
                   cosine[i] = agreement_at(original, triangles[i], hint);
                 }
               });
  NormalDeviation deviation;
  for (std::size_t i = 0; i < cosine.size(); ++i) {
    const double c = cosine[i];
    const std::size_t n = all.count(i);
    deviation.triangles += n;
    deviation.above_10deg += c < cosine_10deg ? n : 0;
    deviation.above_60deg += c < cosine_60deg ? n : 0;
    deviation.flips += c < 0 ? n : 0;
  }
  return deviation;
}

}  // namespace aomd::measure
