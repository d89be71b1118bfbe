#pragma once
// VTK's cell types, which SU2 uses too.

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "core/mesh/shape.h"

namespace aomd::io::detail {

/// What a cell becomes.
enum class CellRule : std::uint8_t { Nothing, Points, Lines, Strip, Polygon, Corners };

struct CellKind {
  std::uint8_t type = 0;
  CellRule rule = CellRule::Nothing;
  Shape shape = Shape::Point;
  std::uint8_t nodes = 0;  ///< 0 where the number varies
  std::string_view name;
};

/// The kind of this number; null where cells of it are not read.
[[nodiscard]] const CellKind* cell_kind(int type);

/// "42 (polyhedron)", for messages.
[[nodiscard]] std::string cell_type_name(int type);

/// The number of VTK's linear cell of a built-in shape.
[[nodiscard]] std::uint8_t cell_type(Shape shape);

/// For each of our corners its place in VTK's list. VTK's wedge looks outward at its base (0, 1,
/// 2), our prism inward, as Gmsh's: two corners of either triangle change places. Pixels and voxels
/// count row by row. The orders of linear cells are their own inverses. Source: VTK's class
/// documentation (vtkWedge, vtkVoxel).
[[nodiscard]] std::span<const std::uint8_t> corner_order(const CellKind& kind);

}  // namespace aomd::io::detail
