#include "viewer/scene/surface_changes.h"

#include <algorithm>

namespace aomd::scene {
namespace {

template <typename T>
void make_unique(std::vector<T>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

}  // namespace

bool ChangeReader::can_follow(const HistoryPlace& now) const {
  if (now.generation != place_.generation || now.creations != place_.creations) return false;
  // A cut behind the place where this reader stood took nothing that it has seen.
  return now.epoch == place_.epoch || (now.epoch == place_.epoch + 1 && place_.cursor <= now.last_cut);
}

SurfaceChanges ChangeReader::read(const Mesh& mesh, const Journal& journal, const HistoryPlace& now) {
  SurfaceChanges changes;
  if (now == place_) return changes;
  if (can_follow(now)) {
    collect(journal, now.cursor, changes);
    // Beyond a part of the mesh a fresh start costs less than following.
    changes.everything = 3 * changes.faces.size() > mesh.count(2);
  } else {
    changes.everything = true;
  }
  place_ = now;
  if (!changes.everything) {
    add_faces_of_moved(mesh, changes);
    add_stars(mesh, changes);
    for (const Face f : changes.faces) remember(mesh, f);
    return changes;
  }
  changes = {};
  changes.everything = true;
  remember(mesh);
  return changes;
}

void ChangeReader::collect(const Journal& journal, std::size_t cursor, SurfaceChanges& changes) const {
  const auto [first, last] = std::minmax(place_.cursor, cursor);
  journal.touched(first, last, [&](EntityRef e) {
    if (e.dimension == 0) changes.vertices.emplace_back(e.index);
    if (e.dimension == 1) changes.edges.emplace_back(e.index);
    if (e.dimension == 2) changes.faces.emplace_back(e.index);
  });
  make_unique(changes.vertices);
  make_unique(changes.edges);
  make_unique(changes.faces);
}

void ChangeReader::add_faces_of_moved(const Mesh& mesh, SurfaceChanges& changes) const {
  for (const Vertex v : changes.vertices) {
    if (!mesh.alive(v)) continue;
    for (const Face f : mesh.row<2>(v)) changes.faces.push_back(f);
  }
  make_unique(changes.faces);
}

void ChangeReader::add_stars(const Mesh& mesh, SurfaceChanges& changes) const {
  const auto add = [&](const auto& vertices) {
    for (const Vertex v : vertices)
      if (v.valid()) changes.vertices.push_back(v);
  };
  for (const Face f : changes.faces) {
    if (f.index < triangles_.size()) add(triangles_[f.index]);
    if (mesh.alive(f)) add(mesh.triangle(f));
  }
  for (const Edge e : changes.edges)
    if (mesh.alive(e)) add(mesh.edge_vertices(e));
  make_unique(changes.vertices);
  for (const Vertex v : changes.vertices) {
    if (!mesh.alive(v)) continue;
    for (const Edge e : mesh.row<1>(v)) changes.edges.push_back(e);
  }
  make_unique(changes.edges);
}

void ChangeReader::remember(const Mesh& mesh) {
  triangles_.assign(mesh.capacity(2), {});
  for (const Face f : mesh.faces()) triangles_[f.index] = mesh.triangle(f);
}

void ChangeReader::remember(const Mesh& mesh, Face face) {
  if (face.index >= triangles_.size()) triangles_.resize(face.index + 1);
  triangles_[face.index] = mesh.alive(face) ? mesh.triangle(face) : std::array<Vertex, 3>{};
}

}  // namespace aomd::scene
