#pragma once
// Where a piece of a VTK grid ends.

#include <cstddef>
#include <vector>

#include "core/io/vtk_dataset.h"

namespace aomd::io::detail {

/// The points, ascending, at which some cells of a grid, from one number to another, may touch
/// others: those of sides that one cell alone has, among cells of the highest dimension there, and
/// those that only lower cells have. In memory are 32 B a side of these cells.
[[nodiscard]] std::vector<std::size_t> border_points(const VtkDataset& grid, std::size_t first_cell,
                                                     std::size_t end_cell);

}  // namespace aomd::io::detail
