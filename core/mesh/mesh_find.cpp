// Existence queries (paper, section 2.1.1): through stored adjacency, else through a hash set.

#include <algorithm>

#include "core/base/assertion.h"
#include "core/mesh/mesh.h"
#include "core/mesh/side_index.h"

namespace aomd {
bool Mesh::same_vertices(EntityRef e, std::span<const std::uint32_t> vertices) const {
  VertexBuffer buffer;
  const auto own = vertices_of(e, buffer);
  return own.size() == vertices.size() && std::all_of(own.begin(), own.end(), [&](std::uint32_t v) {
           return std::find(vertices.begin(), vertices.end(), v) != vertices.end();
         });
}

std::uint64_t Mesh::hash_key(EntityRef e) const {
  VertexBuffer buffer;
  return EntityHash::key(vertices_of(e, buffer));
}

void Mesh::build_hash(int dim, std::uint32_t buckets) const {
  EntityHash& set = hashes_[static_cast<std::size_t>(dim)];
  if (set.built()) return;
  set.build(buckets == 0 ? count(dim) : buckets);
  for (std::uint32_t id = 0; id < capacity(dim); ++id)
    if (ids(dim).alive(id)) set.insert(hash_key(EntityRef(dim, id)), id);
}

std::uint32_t Mesh::find_by_hash(int dim, std::span<const std::uint32_t> vertices) const {
  build_hash(dim);
  return hash(dim).find(EntityHash::key(vertices), [&](std::uint32_t id) {
    return same_vertices(EntityRef(dim, id), vertices);
  });
}

std::uint32_t Mesh::find_edge_index(std::uint32_t a, std::uint32_t b) const {
  if (!stored(0, 1)) {
    const std::uint32_t ends[] = {a, b};
    return find_by_hash(1, ends);
  }
  auto row = representation_.up(0, 1).row(a);
  if (const auto row_b = representation_.up(0, 1).row(b); row_b.size() < row.size()) row = row_b;
  for (const std::uint32_t e : row) {
    const std::uint32_t* r = representation_.down(1, 0).row(e);
    if ((r[0] == a && r[1] == b) || (r[0] == b && r[1] == a)) return e;
  }
  return no_index;
}

std::uint32_t Mesh::find(int dim, std::span<const std::uint32_t> vertices) const {
  if (count(dim) == 0) return no_index;
  if (dim == 1) return find_edge_index(vertices[0], vertices[1]);
  std::span<const std::uint32_t> row;
  if (stored(0, dim)) {
    row = representation_.up(0, dim).row(vertices[0]);
    for (const std::uint32_t v : vertices.subspan(1))
      if (const auto other = representation_.up(0, dim).row(v); other.size() < row.size())
        row = other;
  } else if (vertices.size() == 3 && stored(0, 1) && stored(1, 2)) {
    const std::uint32_t e = find_edge_index(vertices[0], vertices[1]);
    if (e == no_index) return no_index;
    row = representation_.up(1, 2).row(e);
  } else {
    return find_by_hash(dim, vertices);
  }
  for (const std::uint32_t id : row)
    if (same_vertices(EntityRef(dim, id), vertices)) return id;
  return no_index;
}

Edge Mesh::find_edge(Vertex a, Vertex b) const {
  if (a.index >= capacity(0) || b.index >= capacity(0) || count(1) == 0) return {};
  return Edge(find_edge_index(a.index, b.index));
}

std::uint32_t Mesh::find_on(int dim, std::span<const Vertex> vertices) const {
  VertexBuffer buffer;
  if (vertices.size() < 3 || vertices.size() > buffer.size()) return no_index;
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    if (vertices[k].index >= capacity(0)) return no_index;
    buffer[k] = vertices[k].index;
  }
  return find(dim, {buffer.data(), vertices.size()});
}

Face Mesh::find_face(std::span<const Vertex> vertices) const { return Face(find_on(2, vertices)); }

Region Mesh::find_region(std::span<const Vertex> vertices) const {
  return Region(find_on(3, vertices));
}

std::uint32_t Mesh::side_of(EntityRef e, int k, int i,
                            std::span<const std::uint32_t> vertices) const {
  if (stored(e.dimension, k)) return representation_.down(e.dimension, k).row(e.index)[i];
  return find(k, SideVertices(shape_template(shape(e)).sub(k, i), vertices.data()).span());
}

}  // namespace aomd
