#include "core/mesh/mesh.h"

#include <algorithm>

#include "core/mesh/check.h"

namespace aomd {
namespace {

bool all_triangles(const EntityList& faces) {
  return std::all_of(faces.shapes.begin(), faces.shapes.end(), [](Shape s) { return s == Shape::Triangle; });
}

void append_entity(const Mesh& mesh, EntityRef e, const std::vector<std::uint32_t>& new_index,
                   EntityList& list) {
  std::array<std::uint32_t, max_shape_vertices> buffer;
  for (const std::uint32_t v : mesh.vertices_of(e, buffer)) list.vertices.push_back(new_index[v]);
  list.shapes.push_back(mesh.shape(e));
  list.classes.push_back(mesh.classification(e));
}

void drop_if_unclassified(std::vector<ModelRef>& classes) {
  if (std::none_of(classes.begin(), classes.end(), [](ModelRef m) { return m.valid(); })) classes.clear();
}

}  // namespace

Mesh::Mesh(const MeshData& data) : positions_(data.positions) {
  AOMD_CHECK(data.regions.empty());
  Level& vertices = level(0);
  vertices.ids.create_many(static_cast<std::uint32_t>(data.positions.size()));
  vertices.classes = data.vertex_classes;
  vertices.classes.resize(data.positions.size());
  const auto faces = static_cast<std::uint32_t>(data.faces.size());
  level(2).ids.create_many(faces);
  if (!all_triangles(data.faces)) level(2).shapes = data.faces.shapes;
  level(2).classes = data.faces.classes;
  level(2).classes.resize(faces);
  DownRows& rows = representation_.down(2, 0);
  rows.allocate(faces, all_triangles(data.faces) ? 3 : 4, false);
  const std::uint32_t* from = data.faces.vertices.data();
  for (std::uint32_t f = 0; f < faces; ++f) {
    const int n = lower_count(Face(f), 0);
    std::copy_n(from, n, rows.row(f));
    from += n;
  }
  representation_.demand(2, 0).user = true;
  if (data.edges.empty()) return;
  set(1, 0);
  for (std::uint32_t e = 0; e < data.edges.size(); ++e) {
    const Vertex a(data.edges.vertices[2 * e]), b(data.edges.vertices[2 * e + 1]);
    const ModelRef model = data.edges.classes.empty() ? ModelRef() : data.edges.classes[e];
    if (const Edge known = find_edge(a, b); known.valid())
      level(1).classes[known.index] = model;
    else
      create_edge(a, b, model);
  }
  edge_hash_.release();
}

std::span<const std::uint32_t> Mesh::vertices_of(
    EntityRef e, std::array<std::uint32_t, max_shape_vertices>& buffer) const {
  if (e.dimension == 0) {
    buffer[0] = e.index;
    return {buffer.data(), 1};
  }
  const auto n = static_cast<std::size_t>(lower_count(e, 0));
  const DownRows& direct = representation_.down(e.dimension, 0);
  if (direct.stored()) return {direct.row(e.index), n};
  AOMD_CHECK(e.dimension == 2 && stored(2, 1));
  const DownRows& sides = representation_.down(2, 1);
  for (std::size_t k = 0; k < n; ++k) {
    const auto ends = edge_vertices(Edge(sides.row(e.index)[k]));
    buffer[k] = ends[(sides.directions(e.index) >> k & 1u) ? 0 : 1].index;
  }
  return {buffer.data(), n};
}

bool Mesh::use_direction(Face f, Edge e) const {
  const DownRows& sides = representation_.down(2, 1);
  const std::uint32_t* row = sides.row(f.index);
  const int n = lower_count(f, 1);
  const auto k = std::find(row, row + n, e.index) - row;
  AOMD_CHECK(k < n);
  return (sides.directions(f.index) >> k & 1u) != 0;
}

std::uint64_t Mesh::edge_key(std::uint32_t e) const {
  return EntityHash::key(std::span(representation_.down(1, 0).row(e), 2));
}

Edge Mesh::find_edge(Vertex a, Vertex b) const {
  if (!representation_.has_level(1)) return {};
  const auto joins = [&](std::uint32_t e, std::uint32_t x, std::uint32_t y) {
    const std::uint32_t* r = representation_.down(1, 0).row(e);
    return (r[0] == x && r[1] == y) || (r[0] == y && r[1] == x);
  };
  if (stored(0, 1)) {
    auto row_a = representation_.up(0, 1).row(a.index);
    const auto row_b = representation_.up(0, 1).row(b.index);
    if (row_b.size() < row_a.size()) row_a = row_b;
    for (const std::uint32_t e : row_a)
      if (joins(e, a.index, b.index)) return Edge(e);
    return {};
  }
  if (!edge_hash_.built()) {
    edge_hash_.build(count(1));
    for (const Edge e : edges()) edge_hash_.insert(edge_key(e.index), e.index);
  }
  const std::uint32_t ends[] = {a.index, b.index};
  return Edge(
      edge_hash_.find(EntityHash::key(ends), [&](std::uint32_t e) { return joins(e, a.index, b.index); }));
}

void Mesh::keep_class_lists(bool keep) {
  class_lists_.reset();
  if (!keep) return;
  class_lists_ = std::make_unique<ClassLists>();
  for (int dim = 0; dim < 4; ++dim)
    for (std::uint32_t id = 0; id < capacity(dim); ++id)
      if (ids(dim).alive(id)) class_lists_->insert(dim, id, level(dim).classes[id]);
}

std::size_t Mesh::entity_bytes() const {
  std::size_t sum = positions_.capacity() * sizeof(glm::dvec3) + (class_lists_ ? class_lists_->bytes() : 0);
  for (const Level& l : levels_)
    sum += l.ids.bytes() + l.classes.capacity() * sizeof(ModelRef) + l.shapes.capacity() * sizeof(Shape);
  return sum;
}

std::size_t Mesh::adjacency_bytes() const {
  std::size_t sum = edge_hash_.bytes();
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      if (stored(i, j)) sum += representation_.bytes(i, j);
  return sum;
}

MeshData to_data(const Mesh& mesh) {
  MeshData data;
  std::vector<std::uint32_t> new_index(mesh.capacity(0), no_index);
  data.positions.reserve(mesh.count(0));
  for (const Vertex v : mesh.vertices()) {
    new_index[v.index] = static_cast<std::uint32_t>(data.positions.size());
    data.positions.push_back(mesh.position(v));
    data.vertex_classes.push_back(mesh.classification(v));
  }
  for (const Edge e : mesh.edges())
    if (mesh.classification(e).dimension() == 1) append_entity(mesh, e, new_index, data.edges);
  for (const Face f : mesh.faces()) append_entity(mesh, f, new_index, data.faces);
  drop_if_unclassified(data.vertex_classes);
  drop_if_unclassified(data.faces.classes);
  return data;
}

}  // namespace aomd
