#pragma once
// A VTK grid as several, which have points on their borders in common, and back.

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/vtk_dataset.h"

namespace aomd::io::detail {

/// Names of the arrays that say which points and cells of the whole those of a piece are.
inline constexpr std::string_view point_ids_name = "GlobalPointIds",
                                  cell_ids_name = "GlobalCellIds";

/// Cuts a grid into so many pieces of equal numbers of cells, along a Hilbert curve through their
/// middles. A point is in each piece that has a cell at it; those that nothing uses are in the
/// first one. Each piece says which points and cells of the whole it has, and keeps the order in
/// which they come there. It follows from the grid and the number alone.
[[nodiscard]] std::vector<VtkDataset> cut_grid(VtkDataset grid, std::size_t pieces);

/// Puts pieces together. Those that all say which points of the whole they have are joined by that,
/// and cells come in the order of the whole; else points on borders are one that are in several
/// pieces at exactly the same place, unless one has two of them there.
class JoinedGrid {
 public:
  /// Throws ReadError where the pieces do not have the same arrays.
  void add(VtkDataset piece, const std::filesystem::path& file);
  [[nodiscard]] VtkDataset finish();
  /// The file that a cell of what finish() returns comes from, and its number there.
  [[nodiscard]] std::string place_of(std::size_t cell) const;

 private:
  struct Piece {
    std::string name;
    std::size_t first_point = 0, first_cell = 0;
  };

  void take_ids();
  void join_by_ids();
  void join_at_borders();
  void keep_points(const std::vector<std::size_t>& kept, const std::vector<std::size_t>& number);
  void order_cells();

  VtkDataset grid_;
  std::vector<Piece> pieces_;
  std::vector<double> point_ids_, cell_ids_;
  std::vector<std::size_t> cell_order_;
};

}  // namespace aomd::io::detail
