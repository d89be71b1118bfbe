#include "core/measure/volume_statistics.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include <glm/geometric.hpp>

#include "core/mesh/bulk.h"

namespace aomd::measure {
namespace {

// Normal of a polygon, its length twice the area (Newell).
glm::dvec3 polygon_normal(const Mesh& mesh, const SideVertices& side) {
  glm::dvec3 sum(0.0);
  const glm::dvec3 origin = mesh.position(Vertex(side.ids[0]));
  for (std::uint32_t k = 1; k + 1 < side.count; ++k)
    sum += glm::cross(mesh.position(Vertex(side.ids[k])) - origin,
                      mesh.position(Vertex(side.ids[k + 1])) - origin);
  return sum;
}

bool has_edge(const SubEntity& face, const SubEntity& edge) {
  const auto end = face.vertices.begin() + shape_template(face.shape).vertex_count;
  return std::find(face.vertices.begin(), end, edge.vertices[0]) != end &&
         std::find(face.vertices.begin(), end, edge.vertices[1]) != end;
}

double angle_between_deg(const glm::dvec3& a, const glm::dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * 180 / std::numbers::pi;
}

}  // namespace

void count_volume_faces(const Mesh& mesh, Counts& counts) {
  using Side =
      std::tuple<std::uint32_t, std::uint64_t, bool>;  // smallest vertex, tag, side of a region
  std::vector<Side> sides;
  const auto add = [&](std::span<const std::uint32_t> v, bool of_region) {
    const FaceKey key(v);
    sides.emplace_back(key.low, v.size() == 3 ? key.tag : ~key.tag, of_region);
  };
  const VertexRows faces(mesh, 2), regions(mesh, 3);
  faces.each([&](std::uint32_t id, const std::uint32_t*) { add(faces.vertices(id), false); });
  regions.each([&](std::uint32_t id, const std::uint32_t* v) {
    const ShapeTemplate& shape = regions.shape(id);
    for (int k = 0; k < shape.face_count; ++k) add(SideVertices(shape.sub(2, k), v).span(), true);
  });
  std::sort(sides.begin(), sides.end());
  counts.faces = 0;
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t used = 0, first = i;
    for (; i < sides.size() && std::get<0>(sides[i]) == std::get<0>(sides[first]) &&
           std::get<1>(sides[i]) == std::get<1>(sides[first]);
         ++i)
      used += std::get<2>(sides[i]);
    ++counts.faces;
    counts.boundary_faces += used == 1;
    counts.nonmanifold_faces += used > 2;
  }
}

double signed_volume(const Mesh& mesh, Region r) {
  VertexBuffer buffer;
  const auto v = mesh.vertices_of(r, buffer);
  const glm::dvec3 origin = mesh.position(Vertex(v[0]));
  const ShapeTemplate& shape = shape_template(mesh.shape(r));
  double sum = 0;
  for (int k = 0; k < shape.face_count; ++k) {
    const SideVertices side(shape.sub(2, k), v.data());
    sum += glm::dot(mesh.position(Vertex(side.ids[0])) - origin, polygon_normal(mesh, side));
  }
  return sum / 6;
}

double smallest_dihedral_deg(const Mesh& mesh, Region r) {
  VertexBuffer buffer;
  const auto v = mesh.vertices_of(r, buffer);
  const ShapeTemplate& shape = shape_template(mesh.shape(r));
  double smallest = 180;
  for (int e = 0; e < shape.edge_count; ++e) {
    std::array<glm::dvec3, 2> normals{};
    std::size_t found = 0;
    for (int f = 0; f < shape.face_count && found < 2; ++f)
      if (has_edge(shape.sub(2, f), shape.sub(1, e)))
        normals[found++] = polygon_normal(mesh, SideVertices(shape.sub(2, f), v.data()));
    if (found == 2) smallest = std::min(smallest, 180 - angle_between_deg(normals[0], normals[1]));
  }
  return smallest;
}

VolumeQuality measure_volume(const Mesh& mesh) {
  VolumeQuality quality;
  for (const Region r : mesh.regions()) {
    const double angle = smallest_dihedral_deg(mesh, r);
    if (!quality.worst.valid() || angle < quality.min_dihedral_deg)
      quality.min_dihedral_deg = angle, quality.worst = r;
    if (!(signed_volume(mesh, r) > 0)) quality.inverted.push_back(r);
  }
  return quality;
}

}  // namespace aomd::measure
