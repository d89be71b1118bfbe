// CGAL's Surface_mesh_simplification: half-edges and one queue of edges. That package is GPL, so
// this program is too, once passed on; it exists to be measured, is built on request only, never
// installed, and nothing else of the project includes or links it.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Bounded_normal_change_filter.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_plane_policies.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_placement.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/version.h>

#include <map>

#include "tools/bench/peers/peer.h"

namespace aomd::peers {
namespace {

namespace sms = CGAL::Surface_mesh_simplification;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Policies = sms::GarlandHeckbert_plane_policies<Mesh, Kernel>;

/// Stops at a number of faces; CGAL's own predicates count edges.
struct FaceCount {
  std::size_t faces;
  template <typename Cost, typename Profile>
  bool operator()(const Cost&, const Profile& profile, std::size_t, std::size_t) const {
    return profile.surface_mesh().number_of_faces() <= faces;
  }
};

/// Returns how many faces it refused.
std::size_t build(const IndexedMesh& from, Mesh& mesh) {
  std::vector<Mesh::Vertex_index> vertices;
  for (const glm::dvec3& p : from.positions) vertices.push_back(mesh.add_vertex({p.x, p.y, p.z}));
  for (const auto& [a, b, c] : from.triangles) mesh.add_face(vertices[a], vertices[b], vertices[c]);
  return from.triangles.size() - mesh.number_of_faces();
}

/// Faces around a non-manifold vertex may be left on a vertex that was removed: collecting garbage
/// would misplace them, so vertices are numbered as faces name them.
IndexedMesh read_back(const Mesh& mesh) {
  IndexedMesh result;
  std::map<Mesh::Vertex_index, std::uint32_t> number;
  for (const auto f : mesh.faces()) {
    auto corner = result.triangles.emplace_back().begin();
    for (const auto v : mesh.vertices_around_face(mesh.halfedge(f))) {
      const auto [entry, first] = number.emplace(v, static_cast<std::uint32_t>(number.size()));
      const Kernel::Point_3& p = mesh.point(v);
      if (first) result.positions.emplace_back(p.x(), p.y(), p.z());
      *corner++ = entry->second;
    }
  }
  return result;
}

/// `collapse(mesh, stop)` simplifies.
template <typename Collapse>
Simplified simplify(const IndexedMesh& from, std::size_t faces, Collapse&& collapse) {
  Mesh mesh;
  const std::size_t rejected = build(from, mesh);
  Simplified simplified;
  simplified.note = rejection(rejected, from.triangles.size());
  simplified.seconds = seconds_of([&] { collapse(mesh, FaceCount{faces}); });
  simplified.mesh = read_back(mesh);
  return simplified;
}

Simplified garland_heckbert(const IndexedMesh& from, std::size_t faces) {
  return simplify(from, faces, [](Mesh& mesh, const FaceCount& stop) {
    const Policies policies(mesh);
    sms::edge_collapse(
        mesh, stop,
        CGAL::parameters::get_cost(policies.get_cost()).get_placement(policies.get_placement()));
  });
}

Simplified garland_heckbert_bounded(const IndexedMesh& from, std::size_t faces) {
  return simplify(from, faces, [](Mesh& mesh, const FaceCount& stop) {
    const Policies policies(mesh);
    sms::edge_collapse(mesh, stop,
                       CGAL::parameters::get_cost(policies.get_cost())
                           .get_placement(policies.get_placement())
                           .filter(sms::Bounded_normal_change_filter<>()));
  });
}

Simplified lindstrom_turk(const IndexedMesh& from, std::size_t faces) {
  return simplify(from, faces, [](Mesh& mesh, const FaceCount& stop) {
    sms::edge_collapse(mesh, stop,
                       CGAL::parameters::get_cost(sms::LindstromTurk_cost<Mesh>())
                           .get_placement(sms::LindstromTurk_placement<Mesh>()));
  });
}

constexpr Method all[] = {{"Garland-Heckbert", garland_heckbert},
                          {"Garland-Heckbert, bounded normals", garland_heckbert_bounded},
                          {"Lindstrom-Turk", lindstrom_turk}};

}  // namespace

std::string library() { return std::string("CGAL ") + CGAL_VERSION_STR; }
std::span<const Method> methods() { return all; }

}  // namespace aomd::peers
