#include "core/repair/triangulate.h"

#include <algorithm>

#include "core/io/face_sink.h"
#include "core/io/formats.h"
#include "core/io/polygon.h"

namespace aomd {
std::size_t triangulate_quads(MeshData& mesh) {
  const auto quads = std::count(mesh.faces.shapes.begin(), mesh.faces.shapes.end(), Shape::Quad);
  if (quads == 0 || !mesh.regions.empty()) return 0;
  EntityList triangles;
  std::vector<std::uint32_t> from, corner_from;
  std::uint32_t face = 0, corner = 0;
  io::detail::for_each_entity(mesh.faces, [&](auto vertices, ModelRef model) {
    io::detail::triangulate(mesh.positions, vertices, triangles.vertices);
    for (; 3 * from.size() < triangles.vertices.size(); from.push_back(face)) {
      triangles.shapes.push_back(Shape::Triangle);
      if (!mesh.faces.classes.empty()) triangles.classes.push_back(model);
    }
    for (; corner_from.size() < triangles.vertices.size() && !mesh.corners.empty();) {
      const std::uint32_t v = triangles.vertices[corner_from.size()];
      corner_from.push_back(
          corner + static_cast<std::uint32_t>(std::find(vertices.begin(), vertices.end(), v) -
                                              vertices.begin()));
    }
    corner += static_cast<std::uint32_t>(vertices.size());
    ++face;
  });
  mesh.faces = std::move(triangles);
  for (Attribute& a : mesh.attributes)
    if (a.dimension == 2) io::detail::take_values(a, from);
  for (Attribute& a : mesh.corners) io::detail::take_values(a, corner_from);
  return static_cast<std::size_t>(quads);
}

}  // namespace aomd
