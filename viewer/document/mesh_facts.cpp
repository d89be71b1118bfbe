#include "viewer/document/mesh_facts.h"

#include <algorithm>
#include <atomic>

#include "core/base/parallel.h"
#include "core/mesh/id_pool.h"
#include "core/mesh/regions_with.h"

namespace aomd::scene {
namespace {

/// How many faces an edge has, 3 standing for more.
int faces_at(const Mesh& mesh, Edge edge) {
  const auto [a, b] = mesh.edge_vertices(edge);
  const auto p = mesh.row<2>(a).indices();
  const auto q = mesh.row<2>(b).indices();
  int common = 0;
  for (std::size_t i = 0, j = 0; i < p.size() && j < q.size() && common < 3;) {
    common += p[i] == q[j];
    const bool step_i = p[i] <= q[j];
    const bool step_j = q[j] <= p[i];
    i += step_i;
    j += step_j;
  }
  return common;
}

void count_shapes(const Mesh& mesh, int dim, MeshFacts& facts) {
  facts.shapes.fill(0);
  if (mesh.uniform_shape(dim)) {
    facts.shapes[static_cast<std::size_t>(mesh.shape({dim, 0}))] = mesh.count(dim);
    return;
  }
  for (std::uint32_t id = 0; id < mesh.capacity(dim); ++id)
    if (mesh.alive({dim, id})) ++facts.shapes[static_cast<std::size_t>(mesh.shape({dim, id}))];
}

bool is_unused(const Mesh& mesh, Vertex v) {
  return mesh.alive(v) && mesh.row<1>(v).empty() && mesh.row<2>(v).empty() &&
         mesh.row<3>(v).empty();
}

std::int64_t count_unused(const Mesh& mesh) {
  if (mesh.stored(0, 1) && mesh.stored(0, 2) && mesh.stored(0, 3)) {
    std::int64_t count = 0;
    for (const Vertex v : mesh.vertices()) count += is_unused(mesh, v);
    return count;
  }
  std::vector<char> used(mesh.capacity(0), 0);
  VertexBuffer buffer;
  for (int dim = 1; dim <= 3; ++dim)
    for (std::uint32_t id = 0; id < mesh.capacity(dim); ++id)
      if (mesh.alive({dim, id}))
        for (const std::uint32_t v : mesh.vertices_of({dim, id}, buffer)) used[v] = 1;
  return mesh.count(0) - std::count(used.begin(), used.end(), 1);
}

/// Outer sides of a prepared volume are entities, each of one region or of none.
bool is_outer(const Mesh& mesh, Face f) {
  if (!mesh.alive(f)) return false;
  VertexBuffer buffer;
  return count_regions_with(mesh, mesh.vertices_of(f, buffer), 2) < 2;
}

}  // namespace

MeshFacts volume_facts(const Mesh& mesh, const Skin& skin) {
  MeshFacts facts;
  facts.vertices = mesh.count(0);
  facts.edges = mesh.count(1);
  facts.faces = mesh.count(2);
  facts.regions = mesh.count(3);
  facts.outer_faces = skin.outer();
  facts.unused = count_unused(mesh);
  count_shapes(mesh, 3, facts);
  return facts;
}

void VolumeFactsKeeper::start(const Mesh& mesh, const Skin& skin) {
  facts_ = volume_facts(mesh, skin);
  outer_.assign(mesh.capacity(2), 0);
  for (const SkinFace& face : skin.faces())
    if (face.outer() && face.face.valid()) outer_[face.face] = 1;
  unused_.assign(mesh.capacity(0), 0);
  if (facts_.unused > 0 && mesh.stored(0, 1) && mesh.stored(0, 2) && mesh.stored(0, 3))
    for (const Vertex v : mesh.vertices()) unused_[v] = is_unused(mesh, v);
}

void VolumeFactsKeeper::update(const Mesh& mesh, const VolumeChanges& changes) {
  if (outer_.size() < mesh.capacity(2)) outer_.resize(mesh.capacity(2), 0);
  if (unused_.size() < mesh.capacity(0)) unused_.resize(mesh.capacity(0), 0);
  facts_.vertices = mesh.count(0);
  facts_.edges = mesh.count(1);
  facts_.faces = mesh.count(2);
  // Only tetrahedra are ever edited.
  facts_.shapes[static_cast<std::size_t>(Shape::Tetrahedron)] += mesh.count(3) - facts_.regions;
  facts_.regions = mesh.count(3);
  for (const Face f : changes.faces) {
    if (f.index >= outer_.size()) continue;
    const std::uint8_t now = is_outer(mesh, f);
    facts_.outer_faces += now - outer_[f];
    outer_[f] = now;
  }
  for (const Vertex v : changes.surroundings) {
    if (v.index >= unused_.size()) continue;
    const std::uint8_t now = is_unused(mesh, v);
    facts_.unused += now - unused_[v];
    unused_[v] = now;
  }
}

void FactsKeeper::update(const Mesh& mesh, const SurfaceChanges& changes) {
  if (changes.everything) {
    look_at_all(mesh);
  } else {
    if (edges_.size() < mesh.capacity(1)) edges_.resize(mesh.capacity(1), EdgeKind::Dead);
    if (unused_.size() < mesh.capacity(0)) unused_.resize(mesh.capacity(0), 0);
    for (const Edge e : changes.edges) look_at(mesh, e);
    for (const Vertex v : changes.vertices) look_at(mesh, v);
  }
  facts_.vertices = mesh.count(0);
  facts_.edges = mesh.count(1);
  facts_.faces = mesh.count(2);
  // Only triangles are ever edited.
  if (!changes.everything) facts_.shapes[static_cast<std::size_t>(Shape::Triangle)] = facts_.faces;
}

void FactsKeeper::look_at_all(const Mesh& mesh) {
  constexpr std::size_t a_piece = 8192;
  facts_ = {};
  edges_.assign(mesh.capacity(1), EdgeKind::Dead);
  unused_.assign(mesh.capacity(0), 0);
  std::atomic<std::int64_t> boundary = 0, nonmanifold = 0, unused = 0;
  parallel_for(mesh.capacity(1), thread_count(0), a_piece, [&](std::size_t begin, std::size_t end) {
    MeshFacts here;
    each_alive(mesh.ids(1), begin, end, [&](std::uint32_t id) {
      count(edges_[Edge(id)] = kind_of(mesh, Edge(id)), +1, here);
    });
    boundary += here.boundary;
    nonmanifold += here.nonmanifold;
  });
  parallel_for(mesh.capacity(0), thread_count(0), a_piece, [&](std::size_t begin, std::size_t end) {
    each_alive(mesh.ids(0), begin, end, [&](std::uint32_t id) {
      unused += unused_[Vertex(id)] = mesh.row<2>(Vertex(id)).empty() ? 1 : 0;
    });
  });
  facts_.boundary = boundary;
  facts_.nonmanifold = nonmanifold;
  facts_.unused = unused;
  count_shapes(mesh, 2, facts_);
}

void FactsKeeper::count(EdgeKind kind, std::int64_t by, MeshFacts& facts) {
  if (kind == EdgeKind::Boundary) facts.boundary += by;
  if (kind == EdgeKind::NonManifold) facts.nonmanifold += by;
}

FactsKeeper::EdgeKind FactsKeeper::kind_of(const Mesh& mesh, Edge edge) {
  constexpr EdgeKind by_faces[] = {EdgeKind::Bare, EdgeKind::Boundary, EdgeKind::Inner,
                                   EdgeKind::NonManifold};
  return mesh.alive(edge) ? by_faces[faces_at(mesh, edge)] : EdgeKind::Dead;
}

void FactsKeeper::look_at(const Mesh& mesh, Edge edge) {
  if (edge.index >= edges_.size()) return;
  const EdgeKind now = kind_of(mesh, edge);
  count(edges_[edge], -1, facts_);
  count(now, +1, facts_);
  edges_[edge] = now;
}

void FactsKeeper::look_at(const Mesh& mesh, Vertex vertex) {
  if (vertex.index >= unused_.size()) return;
  const std::uint8_t now = mesh.alive(vertex) && mesh.row<2>(vertex).empty() ? 1 : 0;
  facts_.unused += now - unused_[vertex];
  unused_[vertex] = now;
}

}  // namespace aomd::scene
