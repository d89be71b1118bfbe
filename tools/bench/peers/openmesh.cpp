// OpenMesh (BSD): half-edges and one queue of vertices.

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/System/config.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>

#include "tools/bench/peers/peer.h"

namespace aomd::peers {
namespace {

using Mesh = OpenMesh::TriMesh_ArrayKernelT<>;
using Decimater = OpenMesh::Decimater::DecimaterT<Mesh>;
using Quadric = OpenMesh::Decimater::ModQuadricT<Mesh>;
using NormalFlipping = OpenMesh::Decimater::ModNormalFlippingT<Mesh>;

/// Returns how many faces it refused.
std::size_t build(const IndexedMesh& from, Mesh& mesh) {
  mesh.request_vertex_status();
  mesh.request_edge_status();
  mesh.request_halfedge_status();
  mesh.request_face_status();
  mesh.request_face_normals();
  std::vector<Mesh::VertexHandle> vertices;
  for (const glm::dvec3& p : from.positions)
    vertices.push_back(mesh.add_vertex(
        Mesh::Point(static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z))));
  for (const auto& [a, b, c] : from.triangles) mesh.add_face(vertices[a], vertices[b], vertices[c]);
  mesh.update_face_normals();
  return from.triangles.size() - mesh.n_faces();
}

IndexedMesh read_back(Mesh& mesh) {
  mesh.garbage_collection();
  IndexedMesh result;
  for (const auto v : mesh.vertices()) {
    const Mesh::Point& p = mesh.point(v);
    result.positions.emplace_back(p[0], p[1], p[2]);
  }
  for (const auto f : mesh.faces()) {
    auto v = mesh.cfv_iter(f);
    std::array<std::uint32_t, 3> corners;
    for (auto& corner : corners) corner = static_cast<std::uint32_t>((v++)->idx());
    result.triangles.push_back(corners);
  }
  return result;
}

Simplified simplify(const IndexedMesh& from, std::size_t faces, bool keep_normals) {
  Mesh mesh;
  const std::size_t rejected = build(from, mesh);
  Simplified simplified;
  simplified.note = rejection(rejected, from.triangles.size());
  simplified.seconds = seconds_of([&] {
    Decimater decimater(mesh);
    Quadric::Handle quadric;
    decimater.add(quadric);
    decimater.module(quadric).unset_max_err();
    NormalFlipping::Handle normals;
    if (keep_normals) decimater.add(normals);
    decimater.initialize();
    decimater.decimate_to_faces(0, faces);
  });
  simplified.mesh = read_back(mesh);
  return simplified;
}

constexpr Method all[] = {
    {"quadric",
     [](const IndexedMesh& mesh, std::size_t faces) { return simplify(mesh, faces, false); }},
    {"quadric, normal flipping",
     [](const IndexedMesh& mesh, std::size_t faces) { return simplify(mesh, faces, true); }}};

}  // namespace

std::string library() {
  return "OpenMesh " + std::to_string(OM_GET_VER) + "." + std::to_string(OM_GET_MAJ);
}
std::span<const Method> methods() { return all; }

}  // namespace aomd::peers
