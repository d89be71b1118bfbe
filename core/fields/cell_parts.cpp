#include "core/fields/cell_parts.h"

#include <algorithm>

namespace aomd::fields {
namespace {

/// Corners of the fan around a cell's first vertex; an edge is one thin triangle.
template <typename Visit>
void each_triangle(const Cells& cells, std::uint32_t i, Visit&& visit) {
  if (cells.dimension() == 1)
    return visit(Triangle{cells.corner(i, 0), cells.corner(i, 1), cells.corner(i, 1)});
  for (std::size_t k = 2; k < cells.vertices(i).size(); ++k)
    visit(Triangle{cells.corner(i, 0), cells.corner(i, k - 1), cells.corner(i, k)});
}

/// The middles of 16 equal pieces of a triangle.
template <typename Visit>
void each_point_on(const Triangle& t, Visit&& visit) {
  constexpr int n = 4;
  const auto point = [&](double y, double z) {
    visit(t[0] + y / (3 * n) * (t[1] - t[0]) + z / (3 * n) * (t[2] - t[0]));
  };
  for (int i = 0; i < n; ++i)
    for (int j = 0; i + j < n; ++j) {
      point(3 * i + 1, 3 * j + 1);
      if (i + j + 1 < n) point(3 * i + 2, 3 * j + 2);
    }
}

/// Points of one weight, 16 for each triangle or on an edge.
template <typename Visit>
void each_point(const Cells& cells, std::uint32_t i, Visit&& visit) {
  if (cells.dimension() == 2)
    return each_triangle(cells, i, [&](const Triangle& t) { each_point_on(t, visit); });
  for (int k = 0; k < 16; ++k)
    visit(cells.corner(i, 0) + (k + 0.5) / 16 * (cells.corner(i, 1) - cells.corner(i, 0)));
}

/// Parts of one cell become one.
void join(std::vector<CellPart>& parts) {
  std::sort(parts.begin(), parts.end(),
            [](const CellPart& a, const CellPart& b) { return a.cell < b.cell; });
  std::size_t last = 0;
  for (std::size_t i = 1; i < parts.size(); ++i) {
    if (parts[i].cell == parts[last].cell)
      parts[last].amount += parts[i].amount;
    else
      parts[++last] = parts[i];
  }
  if (!parts.empty()) parts.resize(last + 1);
}

}  // namespace

void TetParts::of(std::uint32_t i, std::vector<CellPart>& parts) const {
  if (result_.shape(i) != Shape::Tetrahedron) return;
  const ModelRef model = result_.model(i);
  const bool any = original_.mesh().regions.classes.empty() || !model.valid();
  tree_.each_overlap(
      result_.tet(i), [&](std::uint32_t r) { return any || original_.model(r) == model; },
      [&](std::uint32_t r, double volume) {
        parts.push_back({r, volume});
      });
  if (!parts.empty()) return;
  const std::uint32_t nearest = tree_.region_at(result_.centre(i));
  if (nearest != no_index) parts.push_back({nearest, 1});
}

void FaceParts::of(std::uint32_t i, std::vector<CellPart>& parts) const {
  each_point(result_, i, [&](const glm::dvec3& p) {
    if (const std::uint32_t face = pairing_.face_at(p, i); face != no_index)
      parts.push_back({face, 1});
  });
  join(parts);
}

SideParts::SideParts(const Cells& original, const Cells& result, int threads)
    : original_(original), result_(result) {
  std::map<ModelRef, std::vector<std::uint32_t>> by_class;
  for (std::uint32_t i = 0; i < original.size(); ++i) by_class[original.model(i)].push_back(i);
  for (const auto& [model, cells] : by_class) add(model, cells, threads);
}

void SideParts::add(ModelRef model, const std::vector<std::uint32_t>& cells, int threads) {
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> owners;
  for (const std::uint32_t i : cells)
    each_triangle(original_, i, [&](const Triangle& t) {
      triangles.push_back(t);
      owners.push_back(i);
    });
  nearby_.emplace(model, Nearby{TriangleTree(std::move(triangles), threads), std::move(owners)});
}

void SideParts::of(std::uint32_t i, std::vector<CellPart>& parts) const {
  const auto found = nearby_.find(result_.model(i));
  if (found == nearby_.end()) return;
  const Nearby& near = found->second;
  each_point(result_, i, [&](const glm::dvec3& p) {
    const TriangleTree::Nearest nearest = near.tree.nearest(p);
    if (nearest.triangle != no_index)
      parts.push_back({near.cells[near.tree.source(nearest.triangle)], 1});
  });
  join(parts);
}

}  // namespace aomd::fields
