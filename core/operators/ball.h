#pragma once
// The tetrahedra around a vertex, and the model faces there, as the operators look at them.

#include <array>
#include <vector>

#include "core/mesh/mesh.h"
#include "core/mesh/tet_geometry.h"
#include "core/operators/star.h"

#pragma GCC visibility push(default)

namespace aomd {

/// A tetrahedron around a vertex, seen from it: (vertex, others[0], others[1], others[2]) stands
/// upright where the tetrahedron does.
struct BallRegion {
  Region region;
  std::uint32_t slot = 0;  ///< where the vertex stands in the region
  std::array<Vertex, 3> others;
  [[nodiscard]] bool uses(Vertex v) const {
    return (others[0] == v) | (others[1] == v) | (others[2] == v);
  }
};
using Ball = std::vector<BallRegion>;

/// The shape of a tetrahedron of the mesh. T(3,0) must be stored.
[[nodiscard]] inline double tet_shape(const Mesh& mesh, Region r) {
  const auto t = mesh.tetrahedron(r);
  return tet_shape(mesh.position(t[0]), mesh.position(t[1]), mesh.position(t[2]),
                   mesh.position(t[3]));
}

/// The positions of the other vertices for each position of the one that they are seen from: even
/// permutations of the template.
inline constexpr std::array<std::array<std::uint8_t, 3>, 4> seen_from{
    {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

/// Fills `ball` with the tetrahedra around a vertex, in ascending order. T(0,3) and T(3,0) must be
/// stored, all regions around the vertex be tetrahedra. O(regions around it).
inline void gather(const Mesh& mesh, Vertex v, Ball& ball) {
  const Row<3> regions = mesh.row<3>(v);
  ball.resize(regions.size());
  for (std::size_t i = 0; i < regions.size(); ++i) {
    const auto t = mesh.tetrahedron(regions[i]);
    const std::uint32_t slot =
        std::uint32_t{t[1] == v} + 2 * std::uint32_t{t[2] == v} + 3 * std::uint32_t{t[3] == v};
    const auto& from = seen_from[slot];
    ball[i] = {regions[i], slot, {t[from[0]], t[from[1]], t[from[2]]}};
  }
}

/// More tetrahedra around a vertex than this are a crowd, as largest_star is among faces: the
/// vertex takes part in no collapse until enough of its neighbours have gone into each other.
inline constexpr std::size_t largest_ball = 1024;

/// T(0,3) must be stored.
[[nodiscard]] inline bool in_crowd(const Mesh& mesh, Vertex v) {
  return mesh.row<3>(v).size() > largest_ball;
}

/// The first region around a vertex that is no tetrahedron; invalid where all are. T(0,3) must be
/// stored.
[[nodiscard]] inline Region first_other_shape(const Mesh& mesh, Vertex v) {
  if (mesh.uniform_shape(3) && mesh.uniform_shape(3)->vertex_count == 4) return {};
  for (const Region r : mesh.row<3>(v))
    if (mesh.shape(r) != Shape::Tetrahedron) return r;
  return {};
}

/// Fills `star` with the faces around a vertex that lie on model faces, in ascending order: those
/// that are listed, where level 2 is not complete (Mesh::request_listed). T(0,2) and T(2,0) must be
/// stored, these faces be triangles. O(faces around the vertex).
inline void gather_model_faces(const Mesh& mesh, Vertex v, Star& star) {
  gather(mesh, v, star);
  std::erase_if(star,
                [&](const StarFace& f) { return mesh.classification(f.face).dimension() > 2; });
}

/// Calls visit(neighbour) for each vertex that shares a tetrahedron of the ball with its centre;
/// several times for most.
template <typename Visit>
void for_corners(const Ball& ball, Visit&& visit) {
  for (const BallRegion& r : ball)
    for (const Vertex v : r.others) visit(v);
}

}  // namespace aomd

#pragma GCC visibility pop
