#include "core/mesh/regions_with.h"

#include <algorithm>

namespace aomd {

std::size_t count_regions_with(const Mesh& mesh, std::span<const std::uint32_t> vertices,
                               std::size_t most) {
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
  std::size_t found = 0;
  for (std::size_t i = 0; i < regions.size() && found < most; ++i) found += has_all(regions[i]);
  return found;
}

}  // namespace aomd
