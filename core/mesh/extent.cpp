#include "core/mesh/extent.h"

#include <algorithm>

#include "core/base/box.h"

namespace aomd {
namespace {

constexpr double smallest_extent = 1e-20, largest_extent = 1e18;

bool usual(const Box& box) {
  const glm::dvec3 sides = box.high - box.low;
  const double size = box.empty() ? 0 : std::max({sides.x, sides.y, sides.z});
  return size == 0 || (size >= smallest_extent && size <= largest_extent);
}

}  // namespace

// What uses a vertex matters only where all together are unusual.
bool has_usual_extent(const Mesh& mesh) {
  Box all, used;
  for (const Vertex v : mesh.vertices()) all.add(mesh.position(v));
  if (usual(all)) return true;
  VertexBuffer buffer;
  const auto add = [&](EntityRef e) {
    for (const std::uint32_t v : mesh.vertices_of(e, buffer)) used.add(mesh.position(Vertex(v)));
  };
  for (const Face f : mesh.faces()) add(f);
  for (const Region r : mesh.regions()) add(r);
  return usual(used);
}

double diagonal_of(const MeshData& mesh) {
  Box box;
  for (const EntityList* list : {&mesh.faces, &mesh.regions})
    for (const std::uint32_t v : list->vertices) box.add(mesh.positions[v]);
  return box.diagonal();
}

}  // namespace aomd
