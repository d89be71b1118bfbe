#include "core/decimate/hanging.h"

#include "core/mesh/regions_with.h"

namespace aomd {
namespace {

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
    if (may_hang(mesh, e) && count_regions_with(mesh, vertices, 1) == 0) keep(vertices);
  };
  for (const Face f : mesh.faces()) look(f);
  for (const Edge e : mesh.edges()) look(e);
  return all ? all : kept;
}

}  // namespace aomd
