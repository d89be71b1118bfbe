#include "viewer/drawing/skin_patch.h"

#include <algorithm>
#include <span>

#include "core/operators/ball.h"
#include "viewer/base/sort_once.h"
#include "viewer/drawing/drawable.h"

namespace aomd::scene {
namespace {

template <typename T>
void put_at(std::vector<T>& items, std::uint32_t i, const T& value) {
  if (i >= items.size()) items.resize(i + std::size_t{1});
  items[i] = value;
}

/// The sides that changed tetrahedra and faces have, and those that they had.
std::vector<TriangleSide> sides_of(const Mesh& mesh, const VolumeChanges& changes) {
  std::vector<TriangleSide> sides;
  const auto add = [&](TriangleSide side) {
    std::sort(side.begin(), side.end());
    if (side.back().valid()) sides.push_back(side);
  };
  const auto add_all = [&](const std::array<Vertex, 4>& t) {
    for (const auto& [a, b, c] : seen_from) add({t[a], t[b], t[c]});
  };
  for (const auto& t : changes.regions_before) add_all(t);
  for (const Region r : changes.regions)
    if (mesh.alive(r)) add_all(mesh.tetrahedron(r));
  for (const auto& t : changes.faces_before) add(t);
  for (const Face f : changes.faces)
    if (mesh.alive(f)) add(mesh.triangle(f));
  sort_once(sides);
  return sides;
}

}  // namespace

SurfaceChanges SkinPatch::apply(const VolumeChanges& changes) {
  if (surface_.drawn.size() < mesh_.capacity(0)) surface_.drawn.resize(mesh_.capacity(0));
  follow_vertices(changes.vertices);
  for (const TriangleSide& side : sides_of(mesh_, changes)) patch_side(side);
  edges_.insert(edges_.end(), changes.edges_before.begin(), changes.edges_before.end());
  for (const Edge e : changes.edges)
    if (mesh_.alive(e)) edges_.push_back(mesh_.edge_vertices(e));
  for (Ends& ends : edges_) std::sort(ends.begin(), ends.end());
  sort_once(edges_);
  for (const Ends& ends : edges_)
    if (ends[1].valid()) patch_edge(ends);
  for (const Vertex v : changes.surroundings) patch_vertex(v);
  return this->changes();
}

/// Those that are drawn go where the mesh has them now, and take their faces along.
void SkinPatch::follow_vertices(const std::vector<Vertex>& touched) {
  for (const Vertex v : touched) {
    const Vertex drawn = v.index < surface_.drawn.size() ? surface_.drawn[v] : Vertex();
    if (!drawn.valid() || !mesh_.alive(v)) continue;
    surface_.mesh.move(drawn, mesh_.position(v));
    surface_.mesh.set_classification(drawn, mesh_.classification(v));
    changed_vertices_.add(drawn.index);
    for (const Face f : surface_.mesh.row<2>(drawn)) changed_faces_.add(f.index);
  }
}

void SkinPatch::patch_side(const TriangleSide& side) {
  std::optional<ShownFace> shown;
  const bool there =
      std::all_of(side.begin(), side.end(), [&](Vertex v) { return mesh_.alive(v); });
  if (there && style_.faces)
    if (const auto face = skin_face_on(mesh_, side, plane_)) shown = shown_face(*face, style_);
  const Face present = drawn_face(side);
  if (present.valid() && shown && is(present, *shown)) return;
  if (!present.valid() && !shown) return;
  if (present.valid()) remove(present);
  if (shown) add(*shown);
  for (std::size_t i = 0; i < 3; ++i) edges_.push_back({side[i], side[(i + 1) % 3]});
}

/// Halves of quads do not change.
Face SkinPatch::drawn_face(const TriangleSide& side) const {
  TriangleSide drawn;
  for (std::size_t i = 0; i < 3; ++i) {
    drawn[i] = side[i].index < surface_.drawn.size() ? surface_.drawn[side[i]] : Vertex();
    if (!drawn[i].valid()) return {};
  }
  constexpr std::uint32_t halves = hide_edge_01 | hide_edge_12 | hide_edge_20;
  std::sort(drawn.begin(), drawn.end());
  for (const Face f : surface_.mesh.row<2>(drawn[0])) {
    auto t = surface_.mesh.triangle(f);
    std::sort(t.begin(), t.end());
    if (t == drawn && (surface_.flags[f.index] & halves) == 0) return f;
  }
  return {};
}

bool SkinPatch::is(Face drawn, const ShownFace& shown) const {
  const auto t = surface_.mesh.triangle(drawn);
  for (std::size_t i = 0; i < 3; ++i)
    if (surface_.vertices[t[i].index].index != shown.vertices[i]) return false;
  return surface_.mesh.classification(drawn) == shown.model &&
         surface_.flags[drawn.index] == (shown.bright ? highlighted : 0u) &&
         surface_.faces[drawn.index] == shown.face && surface_.regions[drawn.index] == shown.region;
}

void SkinPatch::add(const ShownFace& shown) {
  TriangleSide drawn;
  for (std::size_t i = 0; i < 3; ++i) drawn[i] = draw(Vertex(shown.vertices[i]));
  const Face f = surface_.mesh.create_face(drawn, shown.model);
  put_at(surface_.flags, f.index, shown.bright ? std::uint32_t{highlighted} : 0u);
  put_at(surface_.faces, f.index, shown.face);
  put_at(surface_.regions, f.index, shown.region);
  changed_faces_.add(f.index);
}

void SkinPatch::remove(Face drawn) {
  for (const Vertex v : surface_.mesh.triangle(drawn)) changed_vertices_.add(v.index);
  changed_faces_.add(drawn.index);
  surface_.mesh.destroy_unused(drawn);
}

Vertex SkinPatch::draw(Vertex v) {
  Vertex& drawn = surface_.drawn[v];
  if (drawn.valid()) return drawn;
  drawn = surface_.mesh.create_vertex(mesh_.position(v), mesh_.classification(v));
  put_at(surface_.vertices, drawn.index, v);
  changed_vertices_.add(drawn.index);
  return drawn;
}

/// What an edge of the surface lies on, given what that of the mesh lies on.
ModelRef SkinPatch::class_of(const Ends& drawn, ModelRef model) const {
  if (model.dimension() == 1) return model;
  if (!surface_.named && parts_classes(surface_.mesh, drawn[0], drawn[1])) return unnamed_border;
  return {};
}

void SkinPatch::patch_edge(const Ends& ends) {
  const bool there = mesh_.alive(ends[0]) && mesh_.alive(ends[1]);
  const Edge own = there ? mesh_.find_edge(ends[0], ends[1]) : Edge();
  const ModelRef model = own.valid() ? mesh_.classification(own) : ModelRef();
  if (model.dimension() == 1)
    for (const Vertex v : ends) draw(v);
  Ends drawn;
  for (std::size_t i = 0; i < 2; ++i) {
    drawn[i] = ends[i].index < surface_.drawn.size() ? surface_.drawn[ends[i]] : Vertex();
    if (!drawn[i].valid()) return;
  }
  Edge e = surface_.mesh.find_edge(drawn[0], drawn[1]);
  const auto faces = surface_.mesh.row<2>(drawn[0]);
  const bool used = std::any_of(faces.begin(), faces.end(), [&](Face f) {
    const auto t = surface_.mesh.triangle(f);
    return std::find(t.begin(), t.end(), drawn[1]) != t.end();
  });
  if (!used && model.dimension() != 1) {
    if (!e.valid()) return;
    changed_edges_.add(e.index);
    return surface_.mesh.destroy_unused(e);
  }
  if (!e.valid()) e = surface_.mesh.create_edge(drawn[0], drawn[1]);
  surface_.mesh.set_classification(e, class_of(drawn, model));
  changed_edges_.add(e.index);
}

/// Model vertices are drawn where nothing else is.
void SkinPatch::patch_vertex(Vertex v) {
  if (v.index >= surface_.drawn.size()) return;
  if (mesh_.alive(v) && mesh_.classification(v).dimension() == 0) {
    draw(v);
    return;
  }
  Vertex& drawn = surface_.drawn[v];
  if (!drawn.valid() || !surface_.mesh.row<1>(drawn).empty()) return;
  changed_vertices_.add(drawn.index);
  surface_.mesh.destroy_unused(drawn);
  drawn = {};
}

SurfaceChanges SkinPatch::changes() {
  const Mesh& surface = surface_.mesh;
  SurfaceChanges changes;
  changes.faces = changed_faces_.take<Face>();
  for (const Face f : changes.faces)
    if (surface.alive(f))
      for (const Vertex v : surface.triangle(f)) changed_vertices_.add(v.index);
  changes.vertices = changed_vertices_.take<Vertex>();
  for (const Vertex v : changes.vertices)
    if (surface.alive(v))
      for (const Edge e : surface.row<1>(v)) changed_edges_.add(e.index);
  changes.edges = changed_edges_.take<Edge>();
  return changes;
}

}  // namespace aomd::scene
