#pragma once
// Grids of VTK that list no cells: their points stand in rows, layers of rows, and so on.

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace aomd::io::detail {

/// Points along x, y and z; one where the grid has no extent that way.
using GridSize = std::array<std::uint64_t, 3>;

/// x * y * z, or `most` + 1 where that is more than `most`.
[[nodiscard]] std::uint64_t points_of(const GridSize& size, std::uint64_t most);

/// Fills the lists with the cells between neighbouring points, x fastest, each by its corners as
/// VTK lists those of its type, which is returned: 12 (hexahedron), 9 (quad), 3 (line), or 1 where
/// a grid of one point has none. Linear.
[[nodiscard]] std::uint8_t add_cells(const GridSize& size, std::vector<std::int64_t>& connectivity,
                                     std::vector<std::int64_t>& ends);

/// All points with these coordinates, x fastest.
[[nodiscard]] std::vector<glm::dvec3> points_on(const std::array<std::vector<double>, 3>& axes);

}  // namespace aomd::io::detail
