#include "core/io/vtk_pieces.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <span>
#include <unordered_map>
#include <utility>

#include "core/base/box.h"
#include "core/base/text.h"
#include "core/io/error.h"
#include "core/io/stored_numbers.h"
#include "core/io/tile_weld.h"
#include "core/io/vtk_borders.h"
#include "core/mesh/handle.h"
#include "core/parts/hilbert_grid.h"

namespace aomd::io::detail {
namespace {

constexpr double all_dimensions = 1 << 1 | 1 << 2 | 1 << 3;

std::span<const std::int64_t> corners_of(const VtkDataset& grid, std::size_t cell) {
  const auto begin = static_cast<std::size_t>(cell == 0 ? 0 : grid.ends[cell - 1]);
  return std::span(grid.connectivity)
      .subspan(begin, static_cast<std::size_t>(grid.ends[cell]) - begin);
}

/// The tuples of an array that have these numbers.
VtkArray chosen(const VtkArray& array, const std::vector<std::size_t>& tuples) {
  const auto n = static_cast<std::size_t>(array.components);
  VtkArray some{array.name, array.components, array.integer, {}, array.type, array.meaning};
  some.values.reserve(n * tuples.size());
  for (const std::size_t i : tuples) {
    const auto from = array.values.begin() + static_cast<std::ptrdiff_t>(n * i);
    some.values.insert(some.values.end(), from, from + array.components);
  }
  return some;
}

std::vector<VtkArray> chosen(const std::vector<VtkArray>& arrays,
                             const std::vector<std::size_t>& tuples) {
  std::vector<VtkArray> some;
  some.reserve(arrays.size());
  for (const VtkArray& array : arrays) some.push_back(chosen(array, tuples));
  return some;
}

/// Which of so many pieces each cell is in.
std::vector<std::size_t> pieces_of_cells(const VtkDataset& grid, std::size_t pieces) {
  Box box;
  for (const glm::dvec3& p : grid.points) box.add(p);
  constexpr int bits = 10;
  const HilbertGrid curve(box, bits);
  std::vector<std::pair<std::uint32_t, std::size_t>> order;
  for (std::size_t cell = 0; cell < grid.types.size(); ++cell) {
    const auto points = corners_of(grid, cell);
    glm::dvec3 middle(0.0);
    for (const std::int64_t v : points)
      middle += grid.points[static_cast<std::size_t>(v)] / double(points.size());
    order.emplace_back(curve.place(middle), cell);
  }
  std::sort(order.begin(), order.end());
  std::vector<std::size_t> piece(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) piece[order[i].second] = i * pieces / order.size();
  return piece;
}

VtkArray ids(std::string_view name, const std::vector<std::size_t>& numbers) {
  VtkArray array{std::string(name), 1, true, {}, NumberType::Int64, Meaning::Any};
  array.values.assign(numbers.begin(), numbers.end());
  return array;
}

/// These points and cells of a grid; `number` has no_index for all points, before and after.
VtkDataset piece_of(const VtkDataset& grid, const std::vector<std::size_t>& points,
                    const std::vector<std::size_t>& cells, std::vector<std::uint32_t>& number) {
  VtkDataset piece;
  for (const std::size_t p : points) {
    number[p] = static_cast<std::uint32_t>(piece.points.size());
    piece.points.push_back(grid.points[p]);
  }
  for (const std::size_t cell : cells) {
    for (const std::int64_t v : corners_of(grid, cell))
      piece.connectivity.push_back(number[static_cast<std::size_t>(v)]);
    piece.ends.push_back(static_cast<std::int64_t>(piece.connectivity.size()));
    piece.types.push_back(grid.types[cell]);
  }
  for (const std::size_t p : points) number[p] = no_index;
  piece.point_data = chosen(grid.point_data, points);
  piece.cell_data = chosen(grid.cell_data, cells);
  piece.point_data.push_back(ids(point_ids_name, points));
  piece.cell_data.push_back(ids(cell_ids_name, cells));
  piece.field_data = grid.field_data;
  return piece;
}

VtkArray* coverage_of(VtkDataset& grid) {
  const auto found = std::find_if(grid.field_data.begin(), grid.field_data.end(),
                                  [](const VtkArray& a) { return a.name == coverage_name; });
  return found == grid.field_data.end() ? nullptr : &*found;
}

/// The points that some cells use, ascending.
std::vector<std::size_t> used_by(const VtkDataset& grid, const std::vector<std::size_t>& cells) {
  std::vector<std::size_t> used;
  for (const std::size_t cell : cells)
    for (const std::int64_t v : corners_of(grid, cell)) used.push_back(static_cast<std::size_t>(v));
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  return used;
}

/// Adds the points that nothing uses.
void add_unused(const VtkDataset& grid, std::vector<std::size_t>& points) {
  std::vector<std::uint8_t> used(grid.points.size(), 0);
  for (const std::int64_t v : grid.connectivity) used[static_cast<std::size_t>(v)] = 1;
  for (std::size_t p = 0; p < used.size(); ++p)
    if (used[p] == 0) points.push_back(p);
  std::sort(points.begin(), points.end());
}

/// Takes an array of whole numbers, one a tuple, out of the others; empty where there is none.
std::vector<double> taken_out(std::vector<VtkArray>& arrays, std::string_view name) {
  const VtkArray* found = find_array(arrays, name);
  if (!found || !found->integer || found->components != 1) return {};
  std::vector<double> values = found->values;
  arrays.erase(arrays.begin() + (found - arrays.data()));
  return values;
}

}  // namespace

std::vector<VtkDataset> cut_grid(VtkDataset grid, std::size_t pieces) {
  for (auto* arrays : {&grid.point_data, &grid.cell_data})
    for (VtkArray& array : *arrays) array.type = stored_type(array);  // the same in each piece
  if (VtkArray* coverage = coverage_of(grid)) coverage->values.push_back(all_dimensions);
  std::vector<std::vector<std::size_t>> cells(pieces);
  const std::vector<std::size_t> piece = pieces_of_cells(grid, pieces);
  for (std::size_t cell = 0; cell < piece.size(); ++cell) cells[piece[cell]].push_back(cell);
  std::vector<std::uint32_t> number(grid.points.size(), no_index);
  std::vector<VtkDataset> result;
  for (std::size_t i = 0; i < pieces; ++i) {
    std::vector<std::size_t> points = used_by(grid, cells[i]);
    if (i == 0) add_unused(grid, points);
    result.push_back(piece_of(grid, points, cells[i], number));
  }
  return result;
}

void JoinedGrid::add(VtkDataset piece, const std::filesystem::path& file) {
  const std::size_t first_point = grid_.points.size(), first_cell = grid_.types.size();
  if (first_point + piece.points.size() >= no_index)
    throw LimitError(file.string(), {}, "with the pieces before it more than 2^32 - 2 points");
  pieces_.push_back({file.string(), first_point, first_cell});
  const auto append = [&](std::vector<VtkArray>& into, std::vector<VtkArray>& from, bool first,
                          bool empty) {
    if (empty) return;
    if (first) return into.swap(from);
    for (VtkArray& array : into) {
      const VtkArray* more = find_array(from, array.name);
      if (!more || more->components != array.components || more->integer != array.integer ||
          from.size() != into.size())
        throw ReadError(file.string(), {},
                        "array " + shown(array.name) + " is not the same in every piece");
      array.values.insert(array.values.end(), more->values.begin(), more->values.end());
    }
    if (into.empty() && !from.empty())
      throw ReadError(file.string(), {}, "array " + shown(from[0].name) + " is not in every piece");
  };
  append(grid_.point_data, piece.point_data, first_point == 0, piece.points.empty());
  append(grid_.cell_data, piece.cell_data, first_cell == 0, piece.types.empty());
  if (grid_.field_data.empty()) grid_.field_data = std::move(piece.field_data);
  const auto base = static_cast<std::int64_t>(grid_.connectivity.size());
  grid_.points.insert(grid_.points.end(), piece.points.begin(), piece.points.end());
  for (const std::int64_t v : piece.connectivity)
    grid_.connectivity.push_back(v + static_cast<std::int64_t>(first_point));
  for (const std::int64_t end : piece.ends) grid_.ends.push_back(base + end);
  grid_.types.insert(grid_.types.end(), piece.types.begin(), piece.types.end());
}

VtkDataset JoinedGrid::finish() {
  take_ids();
  if (!point_ids_.empty())
    join_by_ids();
  else
    join_at_borders();
  if (!cell_ids_.empty()) order_cells();
  return std::move(grid_);
}

void JoinedGrid::take_ids() {
  const std::size_t arrays = grid_.cell_data.size();
  point_ids_ = taken_out(grid_.point_data, point_ids_name);
  cell_ids_ = taken_out(grid_.cell_data, cell_ids_name);
  VtkArray* coverage = coverage_of(grid_);
  if (coverage && !coverage->values.empty() && grid_.cell_data.size() < arrays)
    coverage->values.pop_back();
}

void JoinedGrid::join_by_ids() {
  std::vector<std::size_t> order(grid_.points.size()), by(order.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return point_ids_[a] < point_ids_[b]; });
  std::vector<std::size_t> kept;
  for (const std::size_t p : order) {
    if (kept.empty() || point_ids_[kept.back()] != point_ids_[p]) kept.push_back(p);
    if (grid_.points[kept.back()] != grid_.points[p])
      throw ReadError(
          pieces_.front().name, {},
          "and other pieces: a point of " + std::string(point_ids_name) + " is at two places");
    by[p] = kept.size() - 1;
  }
  keep_points(kept, by);
}

void JoinedGrid::join_at_borders() {
  std::vector<TilePlace> places;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const bool last = i + 1 == pieces_.size();
    const std::size_t end = last ? grid_.types.size() : pieces_[i + 1].first_cell;
    for (const std::size_t p : border_points(grid_, pieces_[i].first_cell, end))
      places.push_back(
          {grid_.points[p], static_cast<std::uint32_t>(p), static_cast<std::uint32_t>(i)});
  }
  std::vector<std::size_t> by(grid_.points.size()), kept;
  std::iota(by.begin(), by.end(), std::size_t{0});
  for (const auto& [point, other] : join_places(std::move(places), 0)) by[point] = other;
  std::vector<std::size_t> number(by.size());
  for (std::size_t p = 0; p < by.size(); ++p) {
    if (by[p] == p) kept.push_back(p);
    number[p] = by[p] == p ? kept.size() - 1 : number[by[p]];
  }
  keep_points(kept, number);
}

// Those that are kept, in their new order, and what each of all is then.
void JoinedGrid::keep_points(const std::vector<std::size_t>& kept,
                             const std::vector<std::size_t>& number) {
  for (std::int64_t& v : grid_.connectivity)
    v = static_cast<std::int64_t>(number[static_cast<std::size_t>(v)]);
  std::vector<glm::dvec3> points;
  points.reserve(kept.size());
  for (const std::size_t p : kept) points.push_back(grid_.points[p]);
  grid_.points = std::move(points);
  grid_.point_data = chosen(grid_.point_data, kept);
}

void JoinedGrid::order_cells() {
  cell_order_.resize(grid_.types.size());
  std::iota(cell_order_.begin(), cell_order_.end(), std::size_t{0});
  std::stable_sort(cell_order_.begin(), cell_order_.end(),
                   [&](std::size_t a, std::size_t b) { return cell_ids_[a] < cell_ids_[b]; });
  VtkDataset ordered;
  for (const std::size_t cell : cell_order_) {
    const auto points = corners_of(grid_, cell);
    ordered.connectivity.insert(ordered.connectivity.end(), points.begin(), points.end());
    ordered.ends.push_back(static_cast<std::int64_t>(ordered.connectivity.size()));
    ordered.types.push_back(grid_.types[cell]);
  }
  grid_.connectivity = std::move(ordered.connectivity);
  grid_.ends = std::move(ordered.ends);
  grid_.types = std::move(ordered.types);
  grid_.cell_data = chosen(grid_.cell_data, cell_order_);
}

std::string JoinedGrid::place_of(std::size_t cell) const {
  const std::size_t listed = cell_order_.empty() ? cell : cell_order_[cell];
  std::size_t i = pieces_.size() - 1;
  while (i > 0 && pieces_[i].first_cell > listed) --i;
  return pieces_[i].name + ": cell " + std::to_string(listed - pieces_[i].first_cell);
}

}  // namespace aomd::io::detail
