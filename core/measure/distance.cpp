#include "core/measure/distance.h"

#include <cmath>
#include <cstdint>
#include <utility>

#include <glm/geometric.hpp>

#include "core/base/parallel.h"
#include "core/mesh/column.h"
#include "core/mesh/geometry.h"

namespace aomd::measure {
namespace {

// Points of the unit square, any stretch of which is spread evenly: the additive recurrence of the
// plastic number (Roberts, The Unreasonable Effectiveness of Quasirandom Sequences, 2018), in
// fractions of 2^64.
class EvenPoints {
 public:
  void next() {
    u_ += 0xc13fa9a902a6328f;  // 2^64 / p and 2^64 / p^2, where p^3 = p + 1
    v_ += 0x91e10da5c79e7b1c;
  }
  [[nodiscard]] double u() const { return fraction(u_); }
  [[nodiscard]] double v() const { return fraction(v_); }

 private:
  [[nodiscard]] static double fraction(std::uint64_t x) {
    return static_cast<double>(x >> 11) * 0x1p-53;
  }
  std::uint64_t u_ = std::uint64_t{1} << 63, v_ = std::uint64_t{1} << 63;
};

// A point of a triangle for a point of the unit square, area for area; the far half of the square
// is turned onto the near one.
glm::dvec3 point_of(const Triangle& t, double u, double v) {
  if (u + v > 1) u = 1 - u, v = 1 - v;
  return t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]);
}

double area(const Triangle& t) { return 0.5 * glm::length(area_normal(t[0], t[1], t[2])); }

// Collects the distances of one side: many points are searched for at once, then added up in their
// order. The triangle found last is the hint for the next point; of equally near ones it decides,
// so that it is forgotten at the same points for any number of threads.
class Probe {
 public:
  Probe(const TriangleTree& to, int threads) : to_(to), threads_(threads) {
    points_.reserve(most_points);
  }

  /// Counts in the largest distance only, or in the mean as well.
  void measure(const glm::dvec3& p) { add({p, false, {}}); }
  void sample(const glm::dvec3& p) { add({p, true, {}}); }

  [[nodiscard]] Distance result() {
    measure_all();
    Distance all = distance_;
    all.max = std::sqrt(std::max(max2_, 0.0));
    if (all.samples == 0) return all;
    all.mean = sum_ / static_cast<double>(all.samples);
    all.rms = std::sqrt(sum2_ / static_cast<double>(all.samples));
    return all;
  }

 private:
  struct Point {
    glm::dvec3 place;
    bool in_mean;
    TriangleTree::Nearest found;
  };
  static constexpr std::size_t most_points = 1 << 15, points_a_hint = 256;

  void add(const Point& p) {
    points_.push_back(p);
    if (points_.size() == most_points) measure_all();
  }

  void measure_all() {
    const std::size_t pieces = (points_.size() + points_a_hint - 1) / points_a_hint;
    parallel_for(pieces, threads_, 1, [this](std::size_t begin, std::size_t end) {
      std::uint32_t hint = no_index;
      for (std::size_t i = begin * points_a_hint; i < std::min(end * points_a_hint, points_.size());
           ++i) {
        if (i % points_a_hint == 0) hint = no_index;
        points_[i].found = to_.nearest(points_[i].place, hint);
        hint = points_[i].found.triangle;
      }
    });
    for (const Point& p : points_) count(p);
    points_.clear();
  }

  void count(const Point& p) {
    const double d2 = p.found.distance2;
    if (d2 > max2_) {
      max2_ = d2;
      distance_.worst = p.place;
      distance_.nearest = p.found.point;
    }
    if (!p.in_mean) return;
    sum_ += std::sqrt(d2);
    sum2_ += d2;
    ++distance_.samples;
  }

  const TriangleTree& to_;
  int threads_;
  std::vector<Point> points_;
  Distance distance_;
  double max2_ = -1, sum_ = 0, sum2_ = 0;
};

}  // namespace

Distance distance_from(const Surface& from, const Surface& to, std::size_t samples, int threads) {
  const TriangleTree& triangles = from.tree();
  if (triangles.size() == 0 || to.tree().size() == 0) return {};
  double whole = 0;
  for (std::uint32_t n = 0; n < triangles.size(); ++n) whole += area(triangles.triangle(n));
  const double per_area = whole > 0 ? static_cast<double>(samples) / whole : 0;
  Probe probe(to.tree(), threads);
  EvenPoints points;
  Column<Vertex, char> seen(from.mesh().capacity(0), 0);
  VertexBuffer buffer;
  double due = 0.5;
  for (std::uint32_t n = 0; n < triangles.size(); ++n) {
    for (const std::uint32_t v : from.mesh().vertices_of(from.face(n), buffer)) {
      if (std::exchange(seen[Vertex(v)], char{1})) continue;
      const glm::dvec3 p = from.mesh().position(Vertex(v));
      per_area > 0 ? probe.measure(p) : probe.sample(p);
    }
    for (due += per_area * area(triangles.triangle(n)); due >= 1; due -= 1, points.next())
      probe.sample(point_of(triangles.triangle(n), points.u(), points.v()));
  }
  return probe.result();
}

MutualDistance mutual_distance(const Surface& original, const Surface& result, std::size_t samples,
                               int threads) {
  return {distance_from(original, result, samples, threads),
          distance_from(result, original, samples, threads)};
}

}  // namespace aomd::measure
