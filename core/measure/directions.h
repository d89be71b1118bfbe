#pragma once
// Boxes of directions: of what can be seen from a point, which way is it?

#include <glm/vec3.hpp>

#include "core/base/box.h"
#include "core/model/triangle_tree.h"

namespace aomd::measure {

/// What rounding may do to a unit vector, with room to spare.
inline constexpr double direction_doubt = 1e-12;

[[nodiscard]] Box all_directions();

/// From one point to another, of length 1; not finite where they are equal or the distance is
/// beyond all doubles.
[[nodiscard]] glm::dvec3 direction(const glm::dvec3& from, const glm::dvec3& to);

/// A box around the shorter arc between two directions; around all where one is not finite, or
/// where they are opposite.
[[nodiscard]] Box arc_box(const glm::dvec3& a, const glm::dvec3& b);

/// A box around the normal of the half plane on the side of b of a line along a; around all where
/// there is no plane.
[[nodiscard]] Box half_plane_box(const glm::dvec3& a, const glm::dvec3& b);

/// A box around the ways in which one may turn from the line between two points to a triangle, as
/// directions at right angles to it; around all where the triangle lies on the line or around it.
[[nodiscard]] Box turn_box(const glm::dvec3& from, const glm::dvec3& to, const Triangle& t);

/// A box around the directions in which a triangle lies from a point; around all where the point
/// lies on it.
[[nodiscard]] Box view_box(const glm::dvec3& from, const Triangle& t);

}  // namespace aomd::measure
