#pragma once
// Polygons into triangles.

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace aomd::io::detail {

/// Splits a polygon of n >= 3 vertices, planar or nearly so, into n - 2 triangles of the same
/// orientation and appends their vertices to `out`. Quads get the shorter of the diagonals that
/// fold nothing over; larger polygons are cut ear by ear in their mean plane. Polygons that cross
/// themselves or have no area are split too, somehow. Cost: O(n * (1 + concave corners)).
void triangulate(std::span<const glm::dvec3> positions, std::span<const std::uint32_t> polygon,
                 std::vector<std::uint32_t>& out);

}  // namespace aomd::io::detail
