#include "core/measure/directions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include <glm/geometric.hpp>

#include "core/model/triangle_intersection.h"

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
      bool ahead = false;  // what is seen edge-on lies on the same circle as the axis behind
      for (std::size_t i = 0; i < 3; ++i) {
        const double side = volume(d[i], d[(i + 1) % 3], sign * axis(k));
        least = std::min(least, side), most = std::max(most, side);
        ahead = ahead || sign * d[i][k] > -direction_doubt;
      }
      const bool within = all > -direction_doubt && least > -direction_doubt;
      const bool turned = all < direction_doubt && most < direction_doubt;
      if (ahead && (within || turned)) box.add(sign * axis(k));
    }
}

// What rounding may do to the way from an axis to a point no nearer than this, seen from one end.
constexpr double least_away = 1e-6, turn_doubt = 1e-8;

// Around directions that are all at right angles to an axis: the shorter way between each two,
// which is all the way round where they lie on every side of it.
Box turns_box(std::span<const dvec3> turns, const dvec3& axis) {
  Box box;
  double least = 1, most = -1;
  bool ahead = true;  // no two of them further apart than a right angle
  for (std::size_t i = 0; i < turns.size(); ++i) {
    const dvec3 &a = turns[i], &b = turns[(i + 1) % turns.size()];
    const double side = volume(a, b, axis);
    least = std::min(least, side), most = std::max(most, side);
    const bool near = glm::dot(a, b) > turn_doubt;
    ahead = ahead && near;
    box.add(grown(arc_box(a, b), turn_doubt / (near ? 1 : std::abs(side))));
  }
  const bool around = turns.size() == 3 && (least > -turn_doubt || most < turn_doubt);
  return around && !ahead ? all_directions() : box;
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

Box turn_box(const dvec3& from, const dvec3& to, const Triangle& t) {
  const dvec3 axis = direction(from, to);
  std::array<dvec3, 3> turns;
  std::size_t count = 0;
  double least = 1;
  for (const dvec3& p : t) {
    if (without_area({from, to, p})) continue;  // on the axis, at which all ways meet
    const dvec3 d = direction(from, p), away = d - glm::dot(d, axis) * axis;
    least = std::min(least, glm::length(away));
    turns[count++] = glm::normalize(away);
  }
  if (count == 0 || !(least > least_away)) return all_directions();
  return turns_box(std::span(turns).first(count), axis);
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
