#include "viewer/drawing/inside_keeper.h"

#include <algorithm>
#include <utility>

#include "viewer/base/sort_once.h"

namespace aomd::scene {
namespace {

std::uint64_t key_of(const EdgeEnds& ends) {
  return std::uint64_t{ends[0].index} << 32 | ends[1].index;
}

/// The edges that changed tetrahedra have, and those that they had.
std::vector<EdgeEnds> edges_of(const Mesh& mesh, const VolumeChanges& changes) {
  std::vector<EdgeEnds> edges;
  const auto add = [&](const auto& corners) {
    if (!corners.back().valid()) return;
    for (std::size_t i = 0; i < corners.size(); ++i)
      for (std::size_t k = i + 1; k < corners.size(); ++k)
        edges.push_back({std::min(corners[i], corners[k]), std::max(corners[i], corners[k])});
  };
  for (const auto& t : changes.regions_before) add(t);
  for (const Region r : changes.regions)
    if (mesh.alive(r)) add(mesh.tetrahedron(r));
  for (const auto& t : changes.faces_before) add(t);
  for (const Face f : changes.faces)
    if (mesh.alive(f)) add(mesh.triangle(f));
  sort_once(edges);
  return edges;
}

/// A place that is free, or one more at the end.
template <typename T>
std::uint32_t take_place(std::vector<std::uint32_t>& free, Patched<T>& array, std::size_t stride) {
  if (free.empty()) {
    const std::size_t size = array.size();
    array.resize(size + stride);
    return static_cast<std::uint32_t>(size / stride);
  }
  const std::uint32_t place = free.back();
  free.pop_back();
  return place;
}

}  // namespace

void InsideKeeper::draw(const Mesh& mesh, const Skin& skin, const CellStyle& style,
                        Drawable& drawable) {
  CellFaces faces = paint_cells(mesh, skin, style, drawable.origin);
  drawable.cells.assign(std::move(faces.corners));
  cell_regions_ = std::move(faces.regions);
  edges_.clear();
  if (style.interior_edges) edges_ = find_inner_edges(mesh, skin, style);
  std::vector<Segment> lines;
  lines.reserve(edges_.size());
  for (const EdgeEnds& ends : edges_)
    lines.push_back(draw_inner_edge(mesh, ends, style, drawable.origin));
  drawable.interior_edges.assign(std::move(lines));
  patched_ = false;
}

void InsideKeeper::find_places() {
  if (std::exchange(patched_, true)) return;
  first_cell_.clear();
  free_cells_.clear();
  free_edges_.clear();
  edge_places_.clear();
  next_cell_.assign(cell_regions_.size(), no_index);
  for (std::uint32_t n = 0; n < cell_regions_.size(); ++n) {
    const Region r = cell_regions_[n];
    if (!r.valid()) continue;
    if (r.index >= first_cell_.size()) first_cell_.resize(r.index + std::size_t{1}, no_index);
    next_cell_[n] = std::exchange(first_cell_[r.index], n);
  }
  for (std::uint32_t n = 0; n < edges_.size(); ++n) edge_places_.emplace(key_of(edges_[n]), n);
  edges_.clear();
}

void InsideKeeper::patch(const Mesh& mesh, const VolumeChanges& changes, const CellStyle& style,
                         Drawable& drawable) {
  find_places();
  if (style.shrink > 0 || style.sections()) patch_cells(mesh, changes, style, drawable);
  if (style.interior_edges) patch_edges(mesh, changes, style, drawable);
}

void InsideKeeper::patch_cells(const Mesh& mesh, const VolumeChanges& changes,
                               const CellStyle& style, Drawable& drawable) {
  for (const Region r : changes.regions) take_cells_away(r, drawable);
  CellPainter painter(mesh, style, drawable.origin);
  for (const Region r : changes.regions) {
    if (!mesh.alive(r)) continue;
    painter.clear();
    painter.add(r);
    const std::vector<Corner>& corners = painter.faces().corners;
    for (std::size_t i = 0; i < corners.size(); i += 3) put(r, &corners[i], drawable);
  }
}

void InsideKeeper::take_cells_away(Region region, Drawable& drawable) {
  if (region.index >= first_cell_.size()) return;
  for (std::uint32_t n = std::exchange(first_cell_[region.index], no_index); n != no_index;
       n = std::exchange(next_cell_[n], no_index)) {
    for (std::size_t i = 3 * std::size_t{n}; i < 3 * std::size_t{n} + 3; ++i)
      drawable.cells.set(i, {});
    cell_regions_[n] = {};
    free_cells_.push_back(n);
  }
}

void InsideKeeper::put(Region region, const Corner* corners, Drawable& drawable) {
  const std::uint32_t n = take_place(free_cells_, drawable.cells, 3);
  if (n >= cell_regions_.size()) {
    cell_regions_.resize(n + std::size_t{1});
    next_cell_.resize(n + std::size_t{1}, no_index);
  }
  for (std::size_t i = 0; i < 3; ++i) drawable.cells.set(3 * std::size_t{n} + i, corners[i]);
  cell_regions_[n] = region;
  if (region.index >= first_cell_.size())
    first_cell_.resize(region.index + std::size_t{1}, no_index);
  next_cell_[n] = std::exchange(first_cell_[region.index], n);
}

void InsideKeeper::patch_edges(const Mesh& mesh, const VolumeChanges& changes,
                               const CellStyle& style, Drawable& drawable) {
  for (const EdgeEnds& ends : edges_of(mesh, changes)) {
    const bool inner = is_inner_edge(mesh, ends, style);
    const Segment line = inner ? draw_inner_edge(mesh, ends, style, drawable.origin) : Segment();
    set_edge(ends, inner ? &line : nullptr, drawable);
  }
}

void InsideKeeper::set_edge(const EdgeEnds& ends, const Segment* line, Drawable& drawable) {
  auto place = edge_places_.find(key_of(ends));
  if (line == nullptr) {
    if (place == edge_places_.end()) return;
    drawable.interior_edges.set(place->second, {});
    free_edges_.push_back(place->second);
    edge_places_.erase(place);
    return;
  }
  if (place == edge_places_.end())
    place = edge_places_.emplace(key_of(ends), take_place(free_edges_, drawable.interior_edges, 1))
                .first;
  drawable.interior_edges.set(place->second, *line);
}

}  // namespace aomd::scene
