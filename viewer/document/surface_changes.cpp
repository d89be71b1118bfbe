#include "viewer/document/surface_changes.h"

#include <algorithm>

#include "core/base/parallel.h"
#include "core/mesh/id_pool.h"

namespace aomd::scene {
namespace {

/// Records of an operation on triangles hold about so many words for each face that they touch.
constexpr std::size_t words_per_face = 12;

}  // namespace

bool can_follow(const HistoryPlace& from, const HistoryPlace& to) {
  if (to.creations != from.creations) return false;
  // A cut behind the place where the reader stood took nothing that it has seen.
  return to.epoch == from.epoch || (to.epoch == from.epoch + 1 && from.cursor <= to.last_cut);
}

/// Beyond a part of the mesh a fresh start costs less than following.
bool ChangeReader::is_far(const Mesh& mesh, const Journal& journal, std::size_t cursor) const {
  const auto [first, last] = std::minmax(place_->cursor, cursor);
  return 3 * journal.words_of(first, last) > words_per_face * mesh.count(2);
}

SurfaceChanges ChangeReader::read(const Mesh& mesh, const Journal& journal,
                                  const HistoryPlace& now) {
  SurfaceChanges changes;
  if (now == place_) return changes;
  changes.everything = !place_ || !can_follow(*place_, now) || is_far(mesh, journal, now.cursor);
  if (changes.everything) {
    remember(mesh);
  } else {
    collect(mesh, journal, now.cursor, changes);
    add_stars(mesh, changes);
    for (const Face f : changes.faces) remember(mesh, f);
  }
  place_ = now;
  return changes;
}

void ChangeReader::collect(const Mesh& mesh, const Journal& journal, std::size_t cursor,
                           SurfaceChanges& changes) {
  IdSet* const sets[] = {&vertices_, &edges_, &faces_};
  const auto [first, last] = std::minmax(place_->cursor, cursor);
  journal.touched(first, last, [&](EntityRef e) {
    if (e.dimension < 3) sets[e.dimension]->add(e.index);
  });
  changes.vertices = vertices_.take<Vertex>();
  // A moved vertex takes its faces with it.
  for (const Vertex v : changes.vertices)
    if (mesh.alive(v))
      for (const Face f : mesh.row<2>(v)) faces_.add(f.index);
  changes.faces = faces_.take<Face>();
}

void ChangeReader::add_stars(const Mesh& mesh, SurfaceChanges& changes) {
  const auto add = [&](const auto& vertices) {
    for (const Vertex v : vertices)
      if (v.valid()) vertices_.add(v.index);
  };
  add(changes.vertices);
  for (const Face f : changes.faces) {
    if (f.index < triangles_.size()) add(triangles_[f.index]);
    if (mesh.alive(f)) add(mesh.triangle(f));
  }
  changes.edges = edges_.take<Edge>();
  for (const Edge e : changes.edges) {
    edges_.add(e.index);
    if (mesh.alive(e)) add(mesh.edge_vertices(e));
  }
  changes.vertices = vertices_.take<Vertex>();
  for (const Vertex v : changes.vertices)
    if (mesh.alive(v))
      for (const Edge e : mesh.row<1>(v)) edges_.add(e.index);
  changes.edges = edges_.take<Edge>();
}

void ChangeReader::remember(const Mesh& mesh) {
  constexpr std::size_t faces_a_piece = 16384;
  triangles_.assign(mesh.capacity(2), {});
  parallel_for(mesh.capacity(2), thread_count(0), faces_a_piece,
               [&](std::size_t begin, std::size_t end) {
                 each_alive(mesh.ids(2), begin, end,
                            [&](std::uint32_t id) { triangles_[id] = mesh.triangle(Face(id)); });
               });
}

void ChangeReader::remember(const Mesh& mesh, Face face) {
  if (face.index >= triangles_.size()) triangles_.resize(face.index + 1);
  triangles_[face.index] = mesh.alive(face) ? mesh.triangle(face) : std::array<Vertex, 3>{};
}

}  // namespace aomd::scene
