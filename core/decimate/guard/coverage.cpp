#include "core/decimate/guard/coverage.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace aomd {
namespace {

using Cell = CoveredPoints::Cell;

double distance2(const Cell& cell, const glm::dvec3& p) {
  const glm::dvec3 d = nearest_point(cell.corners, p) - p;
  return glm::dot(d, d);
}

// Those on model faces; a quad is two of one id.
std::vector<Cell> faces_of(const Mesh& mesh) {
  std::vector<Cell> cells;
  cells.reserve(mesh.count(2));
  VertexBuffer buffer;
  const auto at = [&](std::uint32_t v) { return mesh.position(Vertex(v)); };
  for (const Face f : mesh.faces()) {
    const ModelRef model = mesh.classification(f);
    if (model.dimension() == 3) continue;
    const auto v = mesh.vertices_of(f, buffer);
    for (std::size_t k = 2; k < v.size(); ++k)
      cells.push_back({f.index, model, {at(v[0]), at(v[k - 1]), at(v[k])}});
  }
  return cells;
}

std::vector<Cell> edges_of(const Mesh& mesh) {
  std::vector<Cell> cells;
  for (const Edge e : mesh.edges()) {
    const ModelRef model = mesh.classification(e);
    if (model.dimension() != 1) continue;
    const auto [a, b] = mesh.edge_vertices(e);
    cells.push_back({e.index, model, {mesh.position(a), mesh.position(b), mesh.position(b)}});
  }
  return cells;
}

// Each corner once for each model entity that it is on.
void add_corners(const std::vector<Cell>& cells, CoveredPoints& points) {
  using Place = std::array<double, 3>;
  std::vector<std::pair<ModelRef, Place>> all;
  for (const Cell& cell : cells)
    for (const glm::dvec3& p : cell.corners) all.push_back({cell.model, {p.x, p.y, p.z}});
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  for (const auto& [model, p] : all) points.add(model, {p[0], p[1], p[2]});
}

/// The cells on one model entity, in a tree.
struct Part {
  std::vector<std::uint32_t> ids;
  std::vector<Triangle> corners;
};

std::map<ModelRef, Part> parts_of(std::span<const Cell> cells) {
  std::map<ModelRef, Part> parts;
  for (const Cell& cell : cells) {
    Part& part = parts[cell.model];
    part.ids.push_back(cell.id);
    part.corners.push_back(cell.corners);
  }
  return parts;
}

}  // namespace

void CoveredPoints::put(std::uint32_t point, std::uint32_t cell) {
  if (cell >= first_.size()) first_.resize(cell + std::size_t{1}, no_index);
  points_[point].next = std::exchange(first_[cell], point);
}

void CoveredPoints::attach(std::span<const Cell> cells) {
  first_.clear();
  std::map<ModelRef, std::pair<const Part*, TriangleTree>> trees;
  const std::map<ModelRef, Part> parts = parts_of(cells);
  for (const auto& [model, part] : parts)
    trees.emplace(model, std::pair(&part, TriangleTree(part.corners)));
  for (std::uint32_t i = 0; i < points_.size(); ++i) {
    const auto tree = trees.find(points_[i].model);
    if (tree == trees.end()) continue;
    const auto& [part, boxes] = tree->second;
    const TriangleTree::Nearest nearest = boxes.nearest(points_[i].at);
    points_[i].distance2 = nearest.distance2;
    put(i, part->ids[boxes.source(nearest.triangle)]);
  }
}

double CoveredPoints::uncovered(std::span<const std::uint32_t> replaced,
                                std::span<const Cell> cells, double distance) const {
  for (const std::uint32_t id : replaced) {
    if (id >= first_.size()) continue;
    for (std::uint32_t i = first_[id]; i != no_index; i = points_[i].next) {
      const Point& p = points_[i];
      const double most = std::max(distance * distance, p.distance2);
      double least = std::numeric_limits<double>::infinity();
      for (const Cell& cell : cells) {
        if (cell.model != p.model) continue;
        least = std::min(least, distance2(cell, p.at));
        if (least <= most) break;
      }
      if (!(least <= most)) return std::sqrt(least);
    }
  }
  return 0;
}

void CoveredPoints::hand_over(std::span<const std::uint32_t> replaced,
                              std::span<const Cell> cells) {
  std::vector<std::uint32_t> moved;
  for (const std::uint32_t id : replaced) {
    if (id >= first_.size()) continue;
    for (std::uint32_t i = std::exchange(first_[id], no_index); i != no_index; i = points_[i].next)
      moved.push_back(i);
  }
  for (const std::uint32_t i : moved) {
    const Cell* nearest = nullptr;
    points_[i].distance2 = std::numeric_limits<double>::infinity();
    for (const Cell& cell : cells) {
      if (cell.model != points_[i].model) continue;
      if (const double d2 = distance2(cell, points_[i].at); d2 < points_[i].distance2)
        nearest = &cell, points_[i].distance2 = d2;
    }
    if (nearest) put(i, nearest->id);
  }
}

Coverage::Coverage(const Mesh& original, double distance) : distance_(distance) {
  const std::vector<Cell> faces = faces_of(original), edges = edges_of(original);
  add_corners(faces, on_faces_);
  add_corners(edges, on_edges_);
  on_faces_.attach(faces);
  on_edges_.attach(edges);
}

void Coverage::restart(const Mesh& mesh) {
  on_faces_.attach(faces_of(mesh));
  on_edges_.attach(edges_of(mesh));
}

void Coverage::gather(const Change& change) {
  faces_.clear(), edges_.clear(), old_faces_.clear(), old_edges_.clear();
  for (const Face f : change.replaced) old_faces_.push_back(f.index);
  for (const Edge e : change.old_pieces) old_edges_.push_back(e.index);
  for (const auto* list : {&change.created, &change.beside})
    for (const NewFace& f : *list) faces_.push_back({f.face.index, f.model, f.corners});
  for (const auto* list : {&change.pieces, &change.pieces_beside})
    for (const NewPiece& p : *list)
      edges_.push_back({p.edge.index, p.curve, {p.ends[0], p.ends[1], p.ends[1]}});
}

Verdict Coverage::judge(const Change& change) {
  gather(change);
  if (const double far = on_edges_.uncovered(old_edges_, edges_, distance_); far > 0)
    return {Reason::Distance, change.pieces[0].at, far};
  if (const double far = on_faces_.uncovered(old_faces_, faces_, distance_); far > 0)
    return {Reason::Distance, change.created[0].face, far};
  return {};
}

void Coverage::applied(const Change& change) {
  gather(change);
  on_edges_.hand_over(old_edges_, edges_);
  on_faces_.hand_over(old_faces_, faces_);
}

}  // namespace aomd
