#include "core/io/vtk_borders.h"

#include <algorithm>
#include <array>
#include <span>

#include "core/io/vtk_cells.h"
#include "core/mesh/shape.h"

namespace aomd::io::detail {
namespace {

/// The points of a side, ascending, behind -1 for those that it lacks.
using Side = std::array<std::int64_t, 4>;
using CellPoints = std::span<const std::int64_t>;

int dimension_of(const CellKind& kind) {
  switch (kind.rule) {
    case CellRule::Nothing:
    case CellRule::Points:
      return 0;
    case CellRule::Lines:
      return 1;
    case CellRule::Strip:
    case CellRule::Polygon:
      return 2;
    case CellRule::Corners:
      break;
  }
  return shape_template(kind.shape).dimension;
}

void add_side(std::initializer_list<std::int64_t> points, std::vector<Side>& sides) {
  Side side{-1, -1, -1, -1};
  std::copy(points.begin(), points.end(), side.begin());
  std::sort(side.begin(), side.end());
  sides.push_back(side);
}

void add_around(CellPoints v, std::vector<Side>& sides) {
  for (std::size_t k = 0; k < v.size(); ++k) add_side({v[k], v[(k + 1) % v.size()]}, sides);
}

void add_corner_sides(const CellKind& kind, CellPoints v, std::vector<Side>& sides) {
  const std::span<const std::uint8_t> order = corner_order(kind);
  if (v.size() < order.size()) return;  // what is wrong with it is said later
  const ShapeTemplate& shape = shape_template(kind.shape);
  const int level = shape.dimension - 1;
  if (level == 0) add_side({v[0]}, sides), add_side({v[1]}, sides);
  for (int i = 0; level > 0 && i < shape.count(level); ++i) {
    const SubEntity& sub = shape.sub(level, i);
    Side side{-1, -1, -1, -1};
    for (std::size_t k = 0; k < static_cast<std::size_t>(shape_template(sub.shape).vertex_count);
         ++k)
      side[k] = v[order[sub.vertices[k]]];
    std::sort(side.begin(), side.end());
    sides.push_back(side);
  }
}

void add_sides(const CellKind& kind, CellPoints v, std::vector<Side>& sides) {
  if (v.empty()) return;
  if (kind.rule == CellRule::Corners) return add_corner_sides(kind, v, sides);
  if (kind.rule == CellRule::Polygon) return add_around(v, sides);
  if (kind.rule == CellRule::Lines) add_side({v.front()}, sides), add_side({v.back()}, sides);
  for (std::size_t k = 2; kind.rule == CellRule::Strip && k < v.size(); ++k)
    add_around(v.subspan(k - 2, 3), sides);
}

/// Calls visit(points) for each side that is there once.
template <typename Visit>
void each_lone(std::vector<Side>& sides, const Visit& visit) {
  std::sort(sides.begin(), sides.end());
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
    while (end < sides.size() && sides[end] == sides[i]) ++end;
    if (end - i == 1) visit(sides[i]);
  }
}

}  // namespace

std::vector<std::size_t> border_points(const VtkDataset& grid, std::size_t first_cell,
                                       std::size_t end_cell) {
  enum Use : std::uint8_t { Unused, Lower, Inside, Border };
  std::vector<std::uint8_t> use(grid.points.size(), Unused);
  const auto each_cell = [&](const auto& visit) {
    for (std::size_t i = first_cell; i < end_cell; ++i) {
      const CellKind* kind = cell_kind(grid.types[i]);
      const auto begin = static_cast<std::size_t>(i == 0 ? 0 : grid.ends[i - 1]);
      const auto end = static_cast<std::size_t>(grid.ends[i]);
      if (kind) visit(*kind, CellPoints(grid.connectivity).subspan(begin, end - begin));
    }
  };
  int highest = 0;
  each_cell(
      [&](const CellKind& kind, CellPoints) { highest = std::max(highest, dimension_of(kind)); });
  std::vector<Side> sides;
  each_cell([&](const CellKind& kind, CellPoints points) {
    const bool top = dimension_of(kind) == highest;
    for (const std::int64_t v : points) {
      auto& now = use[static_cast<std::size_t>(v)];
      now = std::max(now, std::uint8_t{top ? Inside : Lower});
    }
    if (top) add_sides(kind, points, sides);
  });
  each_lone(sides, [&](const Side& side) {
    for (const std::int64_t v : side)
      if (v >= 0) use[static_cast<std::size_t>(v)] = Border;
  });
  std::vector<std::size_t> border;
  for (std::size_t p = 0; p < use.size(); ++p)
    if (use[p] == Lower || use[p] == Border) border.push_back(p);
  return border;
}

}  // namespace aomd::io::detail
