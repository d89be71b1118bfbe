#include "core/model/analytic_shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace aomd::analytic {
namespace {

constexpr double pi = std::numbers::pi, turn = 2 * pi;
constexpr double infinite = std::numeric_limits<double>::infinity();

template <typename... F>
struct Overloaded : F... {
  using F::operator()...;
};
template <typename... F>
Overloaded(F...) -> Overloaded<F...>;

// A point around an axis: height on it, distance from it, and the unit direction away from it.
struct Cylindrical {
  double z, distance;
  glm::dvec3 away;
  double angle;  ///< from x, in [0, 2 pi)
};

Cylindrical around_axis(const Frame& f, const glm::dvec3& point) {
  const glm::dvec3 d = point - f.origin;
  const double x = glm::dot(d, f.x), y = glm::dot(d, f.y), distance = std::hypot(x, y);
  if (!(distance > 0)) return {glm::dot(d, f.z), 0, f.x, 0};
  const double angle = std::atan2(y, x), positive = angle < 0 ? angle + turn : angle;
  return {glm::dot(d, f.z), distance, (x * f.x + y * f.y) / distance,
          positive < turn ? positive : 0};
}

// The unit vector from `centre` to `point`, or `otherwise` where they are one.
glm::dvec3 direction(const glm::dvec3& centre, const glm::dvec3& point,
                     const glm::dvec3& otherwise) {
  const glm::dvec3 d = point - centre;
  const double length = glm::length(d);
  return length > 0 ? d / length : otherwise;
}

ClosestPoint closest_on(const SegmentShape& s, const glm::dvec3& p) {
  const glm::dvec3 along = s.to - s.from;
  const double t = std::clamp(glm::dot(p - s.from, along) / glm::dot(along, along), 0.0, 1.0);
  return {evaluate(s, {t, 0}), glm::dvec2(t, 0)};
}

// Seen from the centre, the nearest point lies in the direction of the point; past the ends, it is
// the end that is nearer by angle.
ClosestPoint closest_on(const ArcShape& s, const glm::dvec3& p) {
  const Cylindrical c = around_axis(s.frame, p);
  const double past = std::fmod(std::fmod(c.angle - s.from, turn) + turn, turn),
               length = s.to - s.from;
  if (past <= length) return {s.frame.origin + s.radius * c.away, glm::dvec2(s.from + past, 0)};
  const double end = past - length <= turn - past ? s.to : s.from;
  return {s.frame.on_circle(s.radius, end), glm::dvec2(end, 0)};
}

ClosestPoint closest_on(const PlaneShape& s, const glm::dvec3& p) {
  const glm::dvec3 d = p - s.frame.origin;
  return {p - glm::dot(d, s.frame.z) * s.frame.z,
          glm::dvec2(glm::dot(d, s.frame.x), glm::dot(d, s.frame.y))};
}

ClosestPoint closest_on(const CylinderShape& s, const glm::dvec3& p) {
  const Cylindrical c = around_axis(s.frame, p);
  return {s.frame.origin + c.z * s.frame.z + s.radius * c.away, glm::dvec2(c.angle, c.z)};
}

ClosestPoint closest_on(const ConeShape& s, const glm::dvec3& p) {
  const Cylindrical c = around_axis(s.frame, p);
  const double sine = std::sin(s.half_angle), cosine = std::cos(s.half_angle);
  const double along = std::max(0.0, c.distance * sine + c.z * cosine);
  return {s.frame.origin + along * (cosine * s.frame.z + sine * c.away),
          glm::dvec2(c.angle, along * cosine)};
}

ClosestPoint closest_on(const SphereShape& s, const glm::dvec3& p) {
  const Cylindrical c = around_axis(s.frame, p);
  return {s.frame.origin + s.radius * direction(s.frame.origin, p, s.frame.x),
          glm::dvec2(c.angle, std::atan2(c.z, c.distance))};
}

ClosestPoint closest_on(const TorusShape& s, const glm::dvec3& p) {
  const Cylindrical c = around_axis(s.frame, p);
  const glm::dvec3 centre = s.frame.origin + s.major * c.away;
  return {centre + s.minor * direction(centre, p, c.away),
          glm::dvec2(c.angle, std::atan2(c.z, c.distance - s.major))};
}

glm::dvec3 normal_of(const ConeShape& s, const glm::dvec3& p) {
  if (!(closest_on(s, p).parameters->y > 0)) return -s.frame.z;
  return std::cos(s.half_angle) * around_axis(s.frame, p).away - std::sin(s.half_angle) * s.frame.z;
}

glm::dvec3 normal_of(const TorusShape& s, const glm::dvec3& p) {
  const glm::dvec3 away = around_axis(s.frame, p).away;
  return direction(s.frame.origin + s.major * away, p, away);
}

// How far a circle of radius 1 in the x-y plane reaches along the axes.
glm::dvec3 reach(const Frame& f) { return glm::sqrt(f.x * f.x + f.y * f.y); }

Box around(const glm::dvec3& centre, const glm::dvec3& half) {
  return {centre - half, centre + half};
}

// The ends, and the points where the whole circle is furthest along an axis, where the arc has
// them.
Box box_of(const ArcShape& s) {
  Box box;
  box.add(s.frame.on_circle(s.radius, s.from));
  box.add(s.frame.on_circle(s.radius, s.to));
  const Box circle = around(s.frame.origin, s.radius * reach(s.frame));
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      const double extreme = std::atan2(sign * s.frame.y[axis], sign * s.frame.x[axis]);
      if (std::fmod(std::fmod(extreme - s.from, turn) + turn, turn) > s.to - s.from) continue;
      (sign < 0 ? box.low : box.high)[axis] = (sign < 0 ? circle.low : circle.high)[axis];
    }
  }
  return box;
}

}  // namespace

int dimension_of(const AnalyticShape& shape) {
  constexpr int dimensions[] = {0, 1, 1, 2, 2, 2, 2, 2, 3};
  return dimensions[shape.index()];
}

const char* defect(const AnalyticShape& shape) {
  constexpr const char* radius = "needs a radius above 0";
  return std::visit(
      Overloaded{[](const SegmentShape& s) {
                   return s.from != s.to ? nullptr : "needs two different ends";
                 },
                 [](const ArcShape& s) {
                   if (!(s.radius > 0)) return radius;
                   return s.to > s.from && s.to - s.from <= turn * (1 + 1e-15)
                              ? nullptr
                              : "needs from < to <= from + 2 pi";
                 },
                 [](const ConeShape& s) {
                   return s.half_angle > 0 && s.half_angle < pi / 2
                              ? nullptr
                              : "needs an angle between 0 and pi / 2";
                 },
                 [](const CylinderShape& s) { return s.radius > 0 ? nullptr : radius; },
                 [](const SphereShape& s) { return s.radius > 0 ? nullptr : radius; },
                 [](const TorusShape& s) {
                   return s.minor > 0 && s.major > s.minor ? nullptr
                                                           : "needs radii major > minor > 0";
                 },
                 [](const auto&) -> const char* { return nullptr; }},
      shape);
}

ClosestPoint closest(const AnalyticShape& shape, const glm::dvec3& point) {
  return std::visit(Overloaded{[](const PointShape& s) {
                                 return ClosestPoint{s.position, {}};
                               },
                               [&](const RegionShape&) {
                                 return ClosestPoint{point, {}};
                               },
                               [&](const auto& s) { return closest_on(s, point); }},
                    shape);
}

glm::dvec3 normal(const AnalyticShape& shape, const glm::dvec3& point) {
  return std::visit(
      Overloaded{[](const PlaneShape& s) { return s.frame.z; },
                 [&](const CylinderShape& s) { return around_axis(s.frame, point).away; },
                 [&](const SphereShape& s) { return direction(s.frame.origin, point, s.frame.x); },
                 [&](const ConeShape& s) { return normal_of(s, point); },
                 [&](const TorusShape& s) { return normal_of(s, point); },
                 [](const auto&) { return glm::dvec3(0); }},
      shape);
}

std::optional<ParameterRange> range(const AnalyticShape& shape) {
  using Range = std::optional<ParameterRange>;
  return std::visit(
      Overloaded{[](const PointShape&) -> Range { return {}; },
                 [](const RegionShape&) -> Range { return {}; },
                 [](const SegmentShape&) -> Range {
                   return ParameterRange{{0, 0}, {1, 0}, {}};
                 },
                 [](const ArcShape& s) -> Range {
                   return ParameterRange{{s.from, 0}, {s.to, 0}, {s.to - s.from >= turn, false}};
                 },
                 [](const PlaneShape&) -> Range {
                   return ParameterRange{{-infinite, -infinite}, {infinite, infinite}, {}};
                 },
                 [](const CylinderShape&) -> Range {
                   return ParameterRange{{0, -infinite}, {turn, infinite}, {true, false}};
                 },
                 [](const ConeShape&) -> Range {
                   return ParameterRange{{0, 0}, {turn, infinite}, {true, false}};
                 },
                 [](const SphereShape&) -> Range {
                   return ParameterRange{{0, -pi / 2}, {turn, pi / 2}, {true, false}};
                 },
                 [](const TorusShape&) -> Range {
                   return ParameterRange{{0, -pi}, {turn, pi}, {true, true}};
                 }},
      shape);
}

glm::dvec3 evaluate(const AnalyticShape& shape, const glm::dvec2& t) {
  const auto at = [](const Frame& f, double radius, double angle, double z) {
    return f.on_circle(radius, angle) + z * f.z;
  };
  return std::visit(
      Overloaded{
          [](const PointShape& s) { return s.position; },
          [&](const SegmentShape& s) { return (1 - t.x) * s.from + t.x * s.to; },
          [&](const ArcShape& s) { return s.frame.on_circle(s.radius, t.x); },
          [&](const PlaneShape& s) { return s.frame.origin + t.x * s.frame.x + t.y * s.frame.y; },
          [&](const CylinderShape& s) { return at(s.frame, s.radius, t.x, t.y); },
          [&](const ConeShape& s) { return at(s.frame, t.y * std::tan(s.half_angle), t.x, t.y); },
          [&](const SphereShape& s) {
            return at(s.frame, s.radius * std::cos(t.y), t.x, s.radius * std::sin(t.y));
          },
          [&](const TorusShape& s) {
            return at(s.frame, s.major + s.minor * std::cos(t.y), t.x, s.minor * std::sin(t.y));
          },
          [](const RegionShape&) { return glm::dvec3(0); }},
      shape);
}

Box box(const AnalyticShape& shape) {
  return std::visit(
      Overloaded{[](const PointShape& s) {
                   return Box{s.position, s.position};
                 },
                 [](const SegmentShape& s) {
                   return Box{glm::min(s.from, s.to), glm::max(s.from, s.to)};
                 },
                 [](const ArcShape& s) { return box_of(s); },
                 [](const SphereShape& s) { return around(s.frame.origin, glm::dvec3(s.radius)); },
                 [](const TorusShape& s) {
                   return around(s.frame.origin, s.major * reach(s.frame) + s.minor);
                 },
                 [](const auto&) { return Box(); }},
      shape);
}

}  // namespace aomd::analytic
