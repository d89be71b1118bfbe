#include "core/measure/directions.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

namespace aomd::measure {
namespace {

using glm::dvec3;

Box grown(const Box& box, double by) { return {box.low - dvec3(by), box.high + dvec3(by)}; }

bool is_finite(const dvec3& p) { return std::isfinite(p.x + p.y + p.z); }

dvec3 axis(int k) { return {k == 0, k == 1, k == 2}; }

double volume(const dvec3& a, const dvec3& b, const dvec3& c) {
  return glm::dot(glm::cross(a, b), c);
}

// No point of a short arc is further from the chord than its middle.
Box short_arc_box(Box box, const dvec3& a, const dvec3& b) {
  return grown(box, 1 - glm::length(a + b) / 2 + direction_doubt);
}

// The directions between three that the sides alone do not show: the axes, where they lie inside.
void add_axes_within(Box& box, const std::array<dvec3, 3>& d) {
  const double all = volume(d[0], d[1], d[2]);
  for (int k = 0; k < 3; ++k)
    for (const double sign : {-1.0, 1.0}) {
      double least = 1, most = -1;
      for (std::size_t i = 0; i < 3; ++i) {
        const double side = volume(d[i], d[(i + 1) % 3], sign * axis(k));
        least = std::min(least, side), most = std::max(most, side);
      }
      const bool within = all > -direction_doubt && least > -direction_doubt;
      const bool turned = all < direction_doubt && most < direction_doubt;
      if (within || turned) box.add(sign * axis(k));
    }
}

}  // namespace

Box all_directions() { return {dvec3(-1), dvec3(1)}; }

dvec3 direction(const dvec3& from, const dvec3& to) {
  const dvec3 d = to - from, size = glm::abs(d);
  return glm::normalize(d / std::max({size.x, size.y, size.z}));
}

// An arc goes furthest along an axis at an end, or where its circle does.
Box arc_box(const dvec3& a, const dvec3& b) {
  constexpr double short_arc = 0.99;  // the cosine of 8 degrees
  if (!is_finite(a) || !is_finite(b)) return all_directions();
  Box box;
  box.add(a);
  box.add(b);
  if (glm::dot(a, b) > short_arc) return short_arc_box(box, a, b);
  const dvec3 normal = glm::cross(a, b);
  const double sine = glm::length(normal);
  if (!(sine > direction_doubt)) return all_directions();
  for (int k = 0; k < 3; ++k) {
    const dvec3 along = glm::cross(normal, glm::cross(axis(k), normal));
    if (!(glm::length(along) > direction_doubt * sine * sine)) continue;
    for (const dvec3& top : {glm::normalize(along), -glm::normalize(along)})
      if (volume(a, top, normal) > 0 && volume(top, b, normal) > 0) box.add(top);
  }
  return grown(box, direction_doubt + 1e-15 / sine);
}

Box half_plane_box(const dvec3& a, const dvec3& b) {
  const dvec3 normal = glm::cross(a, b);
  const double sine = glm::length(normal);
  if (!(sine > direction_doubt)) return all_directions();
  Box box;
  box.add(normal / sine);
  return grown(box, direction_doubt + 1e-15 / sine);
}

Box view_box(const dvec3& from, const Triangle& t) {
  Box around;
  for (const dvec3& p : t) around.add(p);
  around.add(from);
  const double doubt = direction_doubt * around.diagonal();
  if (!(glm::length(nearest_point(t, from) - from) > doubt)) return all_directions();
  const std::array d{direction(from, t[0]), direction(from, t[1]), direction(from, t[2])};
  Box box;
  for (std::size_t i = 0; i < 3; ++i) box.add(arc_box(d[i], d[(i + 1) % 3]));
  add_axes_within(box, d);
  return box;
}

}  // namespace aomd::measure
