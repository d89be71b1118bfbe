#include "core/io/vtk_cells.h"

#include <algorithm>

namespace aomd::io::detail {
namespace {

constexpr CellRule by_corners = CellRule::Corners;

constexpr CellKind kinds[] = {
    {0, CellRule::Nothing, Shape::Point, 0, "empty cell"},
    {1, CellRule::Points, Shape::Point, 1, "vertex"},
    {2, CellRule::Points, Shape::Point, 0, "poly-vertex"},
    {3, by_corners, Shape::Line, 2, "line"},
    {4, CellRule::Lines, Shape::Line, 0, "poly-line"},
    {5, by_corners, Shape::Triangle, 3, "triangle"},
    {6, CellRule::Strip, Shape::Triangle, 0, "triangle strip"},
    {7, CellRule::Polygon, Shape::Triangle, 0, "polygon"},
    {8, by_corners, Shape::Quad, 4, "pixel"},
    {9, by_corners, Shape::Quad, 4, "quad"},
    {10, by_corners, Shape::Tetrahedron, 4, "tetrahedron"},
    {11, by_corners, Shape::Hexahedron, 8, "voxel"},
    {12, by_corners, Shape::Hexahedron, 8, "hexahedron"},
    {13, by_corners, Shape::Prism, 6, "wedge"},
    {14, by_corners, Shape::Pyramid, 5, "pyramid"},
    {21, by_corners, Shape::Line, 3, "quadratic edge"},
    {22, by_corners, Shape::Triangle, 6, "quadratic triangle"},
    {23, by_corners, Shape::Quad, 8, "quadratic quad"},
    {24, by_corners, Shape::Tetrahedron, 10, "quadratic tetrahedron"},
    {25, by_corners, Shape::Hexahedron, 20, "quadratic hexahedron"},
    {26, by_corners, Shape::Prism, 15, "quadratic wedge"},
    {27, by_corners, Shape::Pyramid, 13, "quadratic pyramid"},
    {28, by_corners, Shape::Quad, 9, "biquadratic quad"},
    {29, by_corners, Shape::Hexahedron, 27, "triquadratic hexahedron"},
    {30, by_corners, Shape::Quad, 6, "quadratic linear quad"},
    {31, by_corners, Shape::Prism, 12, "quadratic linear wedge"},
    {32, by_corners, Shape::Prism, 18, "biquadratic quadratic wedge"},
    {33, by_corners, Shape::Hexahedron, 24, "biquadratic quadratic hexahedron"},
    {34, by_corners, Shape::Triangle, 7, "biquadratic triangle"},
    {35, by_corners, Shape::Line, 4, "cubic line"},
    {37, by_corners, Shape::Pyramid, 19, "triquadratic pyramid"},
    {68, by_corners, Shape::Line, 0, "Lagrange curve"},
    {69, by_corners, Shape::Triangle, 0, "Lagrange triangle"},
    {70, by_corners, Shape::Quad, 0, "Lagrange quad"},
    {71, by_corners, Shape::Tetrahedron, 0, "Lagrange tetrahedron"},
    {72, by_corners, Shape::Hexahedron, 0, "Lagrange hexahedron"},
    {73, by_corners, Shape::Prism, 0, "Lagrange wedge"},
    {74, by_corners, Shape::Pyramid, 0, "Lagrange pyramid"},
    {75, by_corners, Shape::Line, 0, "Bezier curve"},
    {76, by_corners, Shape::Triangle, 0, "Bezier triangle"},
    {77, by_corners, Shape::Quad, 0, "Bezier quad"},
    {78, by_corners, Shape::Tetrahedron, 0, "Bezier tetrahedron"},
    {79, by_corners, Shape::Hexahedron, 0, "Bezier hexahedron"},
    {80, by_corners, Shape::Prism, 0, "Bezier wedge"},
    {81, by_corners, Shape::Pyramid, 0, "Bezier pyramid"},
};

constexpr std::uint8_t as_listed[] = {0, 1, 2, 3, 4, 5, 6, 7};
constexpr std::uint8_t prism_order[] = {0, 2, 1, 3, 5, 4};
constexpr std::uint8_t row_order[] = {0, 1, 3, 2, 4, 5, 7, 6};

/// Where each type stands in `kinds`, or -1.
constexpr auto corner_places = [] {
  std::array<std::int8_t, 256> table{};
  table.fill(-1);
  for (std::size_t i = 0; i < std::size(kinds); ++i)
    table[kinds[i].type] = static_cast<std::int8_t>(i);
  return table;
}();

}  // namespace

const CellKind* cell_kind(int type) {
  if (type < 0 || type > 255) return nullptr;
  const std::int8_t place = corner_places[static_cast<std::size_t>(type)];
  return place < 0 ? nullptr : &kinds[place];
}

std::string cell_type_name(int type) {
  const CellKind* kind = cell_kind(type);
  const std::string_view name = kind         ? kind->name
                                : type == 36 ? "quadratic polygon"
                                : type == 41 ? "convex point set"
                                : type == 42 ? "polyhedron"
                                             : "";
  return std::to_string(type) + (name.empty() ? "" : " (" + std::string(name) + ")");
}

std::uint8_t cell_type(Shape shape) {
  constexpr std::uint8_t types[builtin_shapes] = {1, 3, 5, 9, 10, 14, 13, 12};
  return types[static_cast<std::size_t>(shape)];
}

std::span<const std::uint8_t> corner_order(const CellKind& kind) {
  constexpr std::uint8_t pixel = 8, voxel = 11;
  const auto n = static_cast<std::size_t>(shape_template(kind.shape).vertex_count);
  if (kind.shape == Shape::Prism) return prism_order;
  if (kind.type == pixel || kind.type == voxel) return std::span(row_order).first(n);
  return std::span(as_listed).first(n);
}

}  // namespace aomd::io::detail
