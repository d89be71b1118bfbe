#pragma once
// A model from formulas: points, lines, arcs, and the elementary surfaces.

#include <variant>
#include <vector>

#include "core/model/model.h"

#pragma GCC visibility push(default)

namespace aomd {

/// Where an elementary curve or surface lies: an origin and three orthonormal, right-handed axes.
struct Frame {
  glm::dvec3 origin{0, 0, 0}, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};

  /// z along `axis` (any length but 0); x as near as can be to `toward`, or any where that is
  /// parallel.
  [[nodiscard]] static Frame around(const glm::dvec3& origin, const glm::dvec3& axis,
                                    const glm::dvec3& toward = {1, 0, 0});
  /// The point at distance `radius` from the origin, `angle` radians from x towards y.
  [[nodiscard]] glm::dvec3 on_circle(double radius, double angle) const;
};

// The shapes of entities, each with its parameters (lengths in units of the model, angles in
// radians).

/// A model vertex.
struct PointShape {
  glm::dvec3 position{};
};
/// A straight model edge; its parameter runs from 0 to 1.
struct SegmentShape {
  glm::dvec3 from{}, to{};
};
/// An arc or circle in the x-y plane of its frame; its parameter is the angle from x.
struct ArcShape {
  Frame frame;
  double radius = 1;
  double from = 0,
         to =
             6.283185307179586476925;  ///< from < to <= from + 2 pi: a full circle when equal to it
};
/// The x-y plane of the frame; parameters x and y; normal z.
struct PlaneShape {
  Frame frame;
};
/// A cylinder around z; parameters angle and z; the normal points away from the axis.
struct CylinderShape {
  Frame frame;
  double radius = 1;
};
/// The nappe of a cone that opens from its apex, the origin, towards z; parameters angle and z; the
/// normal points away from the axis (at the apex: against z).
struct ConeShape {
  Frame frame;
  double half_angle = 0.5;  ///< between axis and surface, more than 0 and less than pi / 2
};
/// A sphere; parameters longitude and latitude; the normal points outward.
struct SphereShape {
  Frame frame;
  double radius = 1;
};
/// A torus around z; parameters the angle around z and, in the tube, from its outermost circle
/// towards z.
struct TorusShape {
  Frame frame;
  double major = 1, minor = 0.25;  ///< radius of the tube's centre line, of the tube; major > minor
};
/// A model region has no shape of its own.
struct RegionShape {};

using AnalyticShape = std::variant<PointShape, SegmentShape, ArcShape, PlaneShape, CylinderShape,
                                   ConeShape, SphereShape, TorusShape, RegionShape>;

struct AnalyticEntity {
  std::int32_t tag = 0;
  AnalyticShape shape;  ///< gives the dimension
  std::vector<ModelRef> boundary;
};

/// A modeler over formulas: closest points, normals and parametrisations to rounding, in constant
/// time. Curves end at their ends; surfaces have no border: a face gives the closest point of the
/// whole surface that it lies on, and its box may be larger than what is bounded. Infinite surfaces
/// add nothing to boxes.
class AnalyticModel final : public Model {
 public:
  /// Throws std::invalid_argument as Model does, and for radii and angles out of range.
  explicit AnalyticModel(const std::vector<AnalyticEntity>& entities);

 private:
  [[nodiscard]] ClosestPoint closest_on(std::size_t index, const glm::dvec3& point) const override;
  [[nodiscard]] glm::dvec3 normal_of(std::size_t index, const glm::dvec3& point) const override;
  [[nodiscard]] std::optional<ParameterRange> range_of(std::size_t index) const override;
  [[nodiscard]] glm::dvec3 evaluate_at(std::size_t index,
                                       const glm::dvec2& parameters) const override;
  [[nodiscard]] Box box_of(std::size_t index) const override;

  std::vector<AnalyticShape> shapes_;  ///< by entity
};

/// A cylinder around z with flat ends at z = 0 and `height`: its side is face 1, the ends 2 and 3,
/// their circles edges 1 and 2, all of it region 1. The sample "cylinder" lies on it (radius 1,
/// height 2).
[[nodiscard]] AnalyticModel cylinder_model(double radius, double height);
/// A sphere around the origin: face 1, region 1.
[[nodiscard]] AnalyticModel sphere_model(double radius);
/// A torus around z: face 1, region 1.
[[nodiscard]] AnalyticModel torus_model(double major, double minor);
/// A box from `-size / 2` to `size / 2` with a hole around z: faces 1 to 6 are the sides at low x,
/// high x, low y, high y, low z, high z; face 7 the hole; edges 1 to 12 and vertices 1 to 8 those
/// of the box, edges 13 and 14 the circles at low and high z; region 1.
[[nodiscard]] AnalyticModel drilled_box_model(const glm::dvec3& size, double hole_radius);

}  // namespace aomd

#pragma GCC visibility pop
