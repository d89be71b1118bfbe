#include "core/measure/volume_statistics.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <span>

#include <glm/geometric.hpp>

#include "core/base/parallel.h"
#include "core/mesh/bulk.h"
#include "core/mesh/side_groups.h"
#include "core/mesh/tet_geometry.h"

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

// What is measured of one region.
struct Figures {
  double dihedral_deg = 0, volume = 0, shape = 0;
  bool tetrahedron = false;
};

Figures figures_of(const Mesh& mesh, Region r) {
  Figures figures{smallest_dihedral_deg(mesh, r), signed_volume(mesh, r)};
  figures.tetrahedron = mesh.shape(r) == Shape::Tetrahedron;
  if (figures.tetrahedron) figures.shape = tetrahedron_shape(mesh, r);
  return figures;
}

void count(Region r, const Figures& figures, VolumeQuality& quality) {
  quality.dihedrals.push_back({r, figures.dihedral_deg});
  if (!quality.worst.valid() || figures.dihedral_deg < quality.min_dihedral_deg)
    quality.min_dihedral_deg = figures.dihedral_deg, quality.worst = r;
  if (!(figures.volume > 0)) quality.inverted.push_back(r);
  if (!figures.tetrahedron) return;
  if (quality.tetrahedra == 0 || figures.shape < quality.shape_min)
    quality.shape_min = figures.shape;
  quality.shape_mean += figures.shape;  // the sum, until take_means()
  ++quality.tetrahedra;
}

void take_means(VolumeQuality& quality) {
  if (quality.dihedrals.empty()) return;
  std::vector<double> angles;
  for (const Sample& sample : quality.dihedrals) angles.push_back(sample.value);
  const auto n = static_cast<double>(angles.size());
  const auto below = std::count_if(angles.begin(), angles.end(), [](double a) { return a < 10; });
  quality.mean_dihedral_deg = std::accumulate(angles.begin(), angles.end(), 0.0) / n;
  quality.regions_below_10deg_pct = 100 * static_cast<double>(below) / n;
  const auto p5 = angles.begin() + static_cast<std::ptrdiff_t>(angles.size() / 20);
  std::nth_element(angles.begin(), p5, angles.end());
  quality.p5_dihedral_deg = *p5;
  if (quality.tetrahedra > 0) quality.shape_mean /= static_cast<double>(quality.tetrahedra);
}

}  // namespace

void count_volume_faces(const Mesh& mesh, Counts& counts) {
  counts.faces = 0;
  SideGroups<2>(mesh).each([&](std::span<const SideUse> uses) {
    const auto first = std::partition_point(uses.begin(), uses.end(),
                                            [](const SideUse& use) { return use.dimension < 3; });
    const std::span regions(first, uses.end());
    ++counts.faces;
    counts.boundary_faces += regions.size() == 1;
    counts.nonmanifold_faces += regions.size() > 2;
    counts.folded_faces += regions.size() == 2 && regions[0].forward == regions[1].forward;
  });
}

double signed_volume(const Mesh& mesh, Region r) {
  VertexBuffer buffer;
  const auto v = mesh.vertices_of(r, buffer);
  const auto at = [&](std::size_t i) { return mesh.position(Vertex(v[i])); };
  if (mesh.shape(r) == Shape::Tetrahedron) return six_volumes(at(0), at(1), at(2), at(3)) / 6;
  const glm::dvec3 origin = at(0);
  const ShapeTemplate& shape = shape_template(mesh.shape(r));
  double sum = 0;
  for (int k = 0; k < shape.face_count; ++k) {
    const SideVertices side(shape.sub(2, k), v.data());
    sum += glm::dot(mesh.position(Vertex(side.ids[0])) - origin, polygon_normal(mesh, side));
  }
  return sum / 6;
}

std::vector<RegionVolume> region_volumes(const Mesh& mesh) {
  std::map<ModelRef, RegionVolume> found;
  for (const Region r : mesh.regions()) {
    RegionVolume& all = found[mesh.classification(r)];
    ++all.regions;
    all.volume += signed_volume(mesh, r);
  }
  std::vector<RegionVolume> list;
  for (auto& [model, all] : found) {
    all.model = model;
    list.push_back(all);
  }
  return list;
}

double smallest_dihedral_deg(const Mesh& mesh, Region r) {
  VertexBuffer buffer;
  const auto v = mesh.vertices_of(r, buffer);
  const ShapeTemplate& shape = shape_template(mesh.shape(r));
  double smallest = 180;
  bool measured = false;
  for (int e = 0; e < shape.edge_count; ++e) {
    std::array<glm::dvec3, 2> normals{};
    std::size_t found = 0;
    for (int f = 0; f < shape.face_count && found < 2; ++f)
      if (has_edge(shape.sub(2, f), shape.sub(1, e)))
        normals[found++] = polygon_normal(mesh, SideVertices(shape.sub(2, f), v.data()));
    if (found < 2 || normals[0] == glm::dvec3(0.0) || normals[1] == glm::dvec3(0.0)) continue;
    smallest = std::min(smallest, 180 - angle_between_deg(normals[0], normals[1]));
    measured = true;
  }
  return measured ? smallest : 0;
}

double tetrahedron_shape(const Mesh& mesh, Region r) {
  VertexBuffer buffer;
  const auto v = mesh.vertices_of(r, buffer);
  double squares = 0;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const glm::dvec3 edge = mesh.position(Vertex(v[i])) - mesh.position(Vertex(v[j]));
      squares += glm::dot(edge, edge);
    }
  const double mean = std::sqrt(squares / 6);
  return mean > 0 ? 6 * std::numbers::sqrt2 * signed_volume(mesh, r) / (mean * mean * mean) : 0;
}

VolumeQuality measure_volume(const Mesh& mesh, int threads) {
  std::vector<Figures> all(mesh.capacity(3));
  parallel_for(all.size(), threads, 1024, [&](std::size_t begin, std::size_t end) {
    for (auto id = static_cast<std::uint32_t>(begin); id < end; ++id)
      if (mesh.ids(3).alive(id)) all[id] = figures_of(mesh, Region(id));
  });
  VolumeQuality quality;
  for (const Region r : mesh.regions()) count(r, all[r.index], quality);
  take_means(quality);
  return quality;
}

}  // namespace aomd::measure
