#pragma once
// The grid of one VTU file, before it is a mesh.

#include <optional>
#include <string>

#include "core/io/vtk_dataset.h"

namespace aomd::io::detail {

struct VtuGrid {
  VtkDataset grid;
  std::optional<std::string> passed_over;  ///< for a note
};

/// Throws ReadError and LimitError as read_vtu() does.
[[nodiscard]] VtuGrid read_vtu_grid(const Source& source);

}  // namespace aomd::io::detail
