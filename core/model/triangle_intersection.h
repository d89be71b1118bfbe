#pragma once
// Whether two triangles cut each other, decided exactly.

#include "core/model/triangle_tree.h"

namespace aomd {

/// True where two triangles have more in common than corners of equal position and the edge between
/// two such corners. Touching counts, and so do two triangles with the same three corners, and two
/// in one plane that lie on the same side of a common edge. Exact: what doubles cannot tell is
/// decided by CGAL's exact predicates, for which what is smaller by 60 decades than the largest
/// coordinate is 0. Coordinates must be finite, both triangles have area. About
/// 50 ns for neighbours.
[[nodiscard]] bool intersect(const Triangle& s, const Triangle& t);

/// True where the corners are collinear, exactly.
[[nodiscard]] bool without_area(const Triangle& t);

}  // namespace aomd
