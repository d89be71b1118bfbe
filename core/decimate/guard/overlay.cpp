#include "core/decimate/guard/overlay.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace aomd {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr double tolerance = 1e-9;  // of the area

double cross(const dvec2& a, const dvec2& b) { return a.x * b.y - a.y * b.x; }

}  // namespace

Overlay::Overlay(const Triangle& below, double reach2) : origin_(below[0]), reach2_(reach2) {
  const dvec3 side = below[1] - below[0], up = glm::cross(side, below[2] - below[0]);
  area2_ = glm::length(up);
  if (!(area2_ > 0)) return;
  along_ = glm::normalize(side);
  normal_ = up / area2_;
  across_ = glm::cross(normal_, along_);
  for (std::size_t i = 1; i < 3; ++i) corners_[i] = dvec2(in_frame(below[i]));
}

dvec3 Overlay::in_frame(const dvec3& p) const {
  const dvec3 d = p - origin_;
  return {glm::dot(d, along_), glm::dot(d, across_), glm::dot(d, normal_)};
}

// Leaves what is left of a side (Sutherland and Hodgman 1974).
void Overlay::clip(std::size_t side, Polygon& polygon) const {
  const dvec2 from = corners_[side], way = corners_[(side + 1) % 3] - from;
  std::array<double, most_corners> left;
  for (std::size_t i = 0; i < polygon.size; ++i)
    left[i] = cross(way, dvec2(polygon.corners[i]) - from);
  const Polygon whole = polygon;
  polygon.size = 0;
  for (std::size_t i = 0; i < whole.size; ++i) {
    const std::size_t k = (i + 1) % whole.size;
    const dvec3 &p = whole.corners[i], &q = whole.corners[k];
    if (left[i] >= 0) polygon.corners[polygon.size++] = p;
    if ((left[i] >= 0) != (left[k] >= 0))
      polygon.corners[polygon.size++] = p + left[i] / (left[i] - left[k]) * (q - p);
  }
}

double Overlay::lay(const Triangle& t) {
  Polygon polygon{{in_frame(t[0]), in_frame(t[1]), in_frame(t[2])}, 3};
  for (std::size_t side = 0; side < 3 && polygon.size > 2; ++side) clip(side, polygon);
  if (polygon.size < 3) return -1;
  double area2 = 0, height2 = 0;
  const dvec2 first(polygon.corners[0]);
  for (std::size_t i = 0; i < polygon.size; ++i) {
    const dvec3& p = polygon.corners[i];
    area2 += cross(dvec2(p) - first, dvec2(polygon.corners[(i + 1) % polygon.size]) - first);
    height2 = std::max(height2, p.z * p.z);
  }
  if (height2 > reach2_) return -1;
  laid2_ += std::abs(area2);
  return height2;
}

bool Overlay::complete() const {
  return area2_ > 0 && std::abs(laid2_ - area2_) <= tolerance * area2_;
}

}  // namespace aomd
