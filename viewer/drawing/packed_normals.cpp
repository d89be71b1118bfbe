#include "viewer/drawing/packed_normals.h"

#include <glm/geometric.hpp>

#include "core/base/parallel.h"
#include "core/mesh/id_pool.h"
#include "viewer/drawing/corner_normals.h"
#include "viewer/drawing/drawable.h"

namespace aomd::scene {
namespace {

/// Most vertices of a scan have one normal: for these the faces are gone through in order, which
/// costs the caches less than going around each vertex. The sums are the same, bit by bit, since
/// faces around a vertex are in order too.
class NormalPacker {
 public:
  NormalPacker(const Mesh& mesh, std::size_t items_a_piece)
      : mesh_(mesh),
        items_a_piece_(items_a_piece),
        faces_(mesh.capacity(2)),
        around_(mesh.capacity(0)),
        packed_(3 * std::size_t{mesh.capacity(2)}) {}

  std::vector<std::uint32_t> pack() {
    in_pieces(2, [&](std::uint32_t id) { faces_[Face(id)] = face_normal(mesh_, Face(id)); });
    add_up();
    tell_split_ones();
    in_pieces(2, [&](std::uint32_t id) { take_shared(Face(id)); });
    take_others();
    return std::move(packed_);
  }

 private:
  struct Around {
    glm::vec3 normal{0};  ///< of all faces, weighted by their angles
    std::uint32_t packed = 0;
    std::uint8_t insides = 0;  ///< 1: faces on model regions, 2: on model faces, 3: both
    bool split = false;        ///< faces may have different normals here
  };

  template <typename Visit>
  void in_pieces(int dim, const Visit& visit) const {
    parallel_for(
        mesh_.capacity(dim), thread_count(0), items_a_piece_,
        [&](std::size_t begin, std::size_t end) { each_alive(mesh_.ids(dim), begin, end, visit); });
  }

  void add_up() {
    for (const Face f : mesh_.faces()) {
      const FaceNormal& face = faces_[f];
      const std::uint8_t inside = mesh_.classification(f).dimension() == 3 ? 1 : 2;
      for (std::uint32_t i = 0; i < 3; ++i) {
        Around& around = around_[face.vertices[i]];
        around.normal += face.angle(i) * face.unit;
        around.insides |= inside;
      }
    }
    for (const Vertex v : mesh_.vertices()) {
      Around& around = around_[v];
      around.normal = unit_or_zero(around.normal);
      around.packed = pack_normal(around.normal);
      around.split = around.insides == 3;
    }
  }

  void tell_split_ones() {
    for (const Edge e : mesh_.edges())
      if (mesh_.classification(e).dimension() <= 1)
        for (const Vertex v : mesh_.edge_vertices(e)) around_[v].split = true;
    for (const Face f : mesh_.faces())
      for (const Vertex v : faces_[f].vertices)
        if (!shares_normal(faces_[f].unit, around_[v].normal)) around_[v].split = true;
  }

  void take_shared(Face f) {
    for (std::uint32_t i = 0; i < 3; ++i)
      packed_[3 * std::size_t{f.index} + i] = around_[faces_[f].vertices[i]].packed;
  }

  void take_others() {
    parallel_for(mesh_.capacity(0), thread_count(0), items_a_piece_,
                 [&](std::size_t begin, std::size_t end) {
                   CornerNormals normals(faces_);
                   each_alive(mesh_.ids(0), begin, end, [&](std::uint32_t id) {
                     if (!around_[Vertex(id)].split) return;
                     for (const CornerNormals::Corner& c : normals.at(mesh_, Vertex(id)))
                       packed_[3 * std::size_t{c.face.index} + c.slot] = pack_normal(c.normal);
                   });
                 });
  }

  const Mesh& mesh_;
  std::size_t items_a_piece_;
  Column<Face, FaceNormal> faces_;
  Column<Vertex, Around> around_;
  std::vector<std::uint32_t> packed_;
};

}  // namespace

std::vector<std::uint32_t> pack_normals(const Mesh& mesh, std::size_t items_a_piece) {
  return NormalPacker(mesh, items_a_piece).pack();
}

}  // namespace aomd::scene
