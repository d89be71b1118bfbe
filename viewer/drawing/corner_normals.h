#pragma once
// Normals of triangle corners: smooth within a model face, split where an edge is to look sharp.

#include <algorithm>
#include <array>
#include <cstdint>
#include <numbers>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "core/mesh/column.h"
#include "core/mesh/mesh.h"

namespace aomd::scene {

/// What a triangle brings to the normals of its corners: all that is read of it, in half a line of
/// the cache.
struct alignas(32) FaceNormal {
  std::array<Vertex, 3> vertices;
  glm::vec3 unit{0};              ///< zero where the face has no area
  std::array<float, 2> angles{};  ///< at the first two vertices, radians
  [[nodiscard]] float angle(std::uint32_t slot) const {
    return slot < 2 ? angles[slot]
                    : std::max(0.0f, std::numbers::pi_v<float> - angles[0] - angles[1]);
  }
};
[[nodiscard]] FaceNormal face_normal(const Mesh& mesh, Face face);
[[nodiscard]] glm::vec3 unit_or_zero(const glm::vec3& v);
/// Whether the mean of unit normals around a vertex can stand for that of a face, all being unit.
[[nodiscard]] bool shares_normal(const glm::vec3& of_face, const glm::vec3& mean);

/// Works out the corners around one vertex at a time; holds the scratch space. The mesh must store
/// T(0,1), T(0,2) and T(2,0).
class CornerNormals {
 public:
  struct Corner {
    Face face;
    std::uint32_t slot = 0;  ///< 0..2, where the vertex stands in the face
    Vertex next, previous;   ///< the face's other vertices, in its order
    glm::vec3 normal{0, 0, 1};
  };

  CornerNormals() = default;
  /// With what face_normal() says of all faces, which must outlive this: for many vertices.
  explicit CornerNormals(const Column<Face, FaceNormal>& faces) : faces_(&faces) {}

  /// The corners at `v`, by ascending face ids. Faces share a normal (their own ones weighted by
  /// their angles at v) where they can be reached from each other through edges that are not on
  /// model edges and turn by less than 40 degrees; all share one where no model edge is at v and
  /// each turns by at most 20 degrees from it. Faces on model regions, where a volume is cut open,
  /// share none with those on model faces. Depends on the star of v alone. O(k log k) for k
  /// faces. Valid until the next call.
  [[nodiscard]] std::span<const Corner> at(const Mesh& mesh, Vertex v);

 private:
  struct Side {
    Vertex far;  ///< the other end of the edge from v
    std::uint32_t corner = 0;
  };
  void gather(const Mesh& mesh, Vertex v);
  void add(const Mesh& mesh, Face f, Vertex v, const FaceNormal& normal);
  void find_sharp_ones(const Mesh& mesh, Vertex v);
  [[nodiscard]] bool share_one();
  void join_smooth_ones();
  [[nodiscard]] std::uint32_t root(std::uint32_t i) const;

  const Column<Face, FaceNormal>* faces_ = nullptr;
  std::vector<Corner> corners_;
  std::vector<glm::vec3> normals_;  ///< of the faces, unit length or zero
  std::vector<float> weights_;
  std::vector<char> inside_;  ///< whether the faces lie on model regions
  std::vector<Side> sides_;
  std::vector<Vertex> sharp_;  ///< far ends of model edges at v, sorted
  std::vector<std::uint32_t> parent_;
  std::vector<glm::vec3> sums_;
};

}  // namespace aomd::scene
