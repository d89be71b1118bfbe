#include "core/decimate/hanging.h"

#include <algorithm>

namespace aomd {
namespace {

bool is_side(const Mesh& mesh, std::span<const std::uint32_t> vertices) {
  Row<3> regions = mesh.row<3>(Vertex(vertices[0]));
  for (const std::uint32_t v : vertices)
    if (const Row<3> row = mesh.row<3>(Vertex(v)); row.size() < regions.size()) regions = row;
  const auto has_all = [&](Region r) {
    VertexBuffer buffer;
    const auto own = mesh.vertices_of(r, buffer);
    return std::all_of(vertices.begin(), vertices.end(), [&](std::uint32_t v) {
      return std::find(own.begin(), own.end(), v) != own.end();
    });
  };
  return std::any_of(regions.begin(), regions.end(), has_all);
}

// What lies inside a region is a side of what fills it.
bool may_hang(const Mesh& mesh, EntityRef e) { return mesh.classification(e).dimension() != 3; }

}  // namespace

KeptVertices keep_hanging(const Mesh& mesh, const KeptVertices& kept) {
  std::shared_ptr<Column<Vertex, std::uint8_t>> all;
  VertexBuffer buffer;
  const auto keep = [&](std::span<const std::uint32_t> vertices) {
    if (!all) {
      all = kept ? std::make_shared<Column<Vertex, std::uint8_t>>(*kept)
                 : std::make_shared<Column<Vertex, std::uint8_t>>();
      all->resize(mesh.capacity(0), 0);
    }
    for (const std::uint32_t v : vertices) (*all)[Vertex(v)] = 1;
  };
  const auto look = [&](EntityRef e) {
    const auto vertices = mesh.vertices_of(e, buffer);
    if (may_hang(mesh, e) && !is_side(mesh, vertices)) keep(vertices);
  };
  for (const Face f : mesh.faces()) look(f);
  for (const Edge e : mesh.edges()) look(e);
  return all ? all : kept;
}

}  // namespace aomd
