#pragma once
// Which place of an original surface each place of the result corresponds to.

#include <vector>

#include "core/fields/same_place.h"
#include "core/fields/sided_tree.h"
#include "core/fields/vertex_values.h"

namespace aomd::fields {

/// A place on the original: in which face, and of which of its vertices by weight.
struct SurfacePlace {
  std::uint32_t face = no_index;
  VertexSource corners;
};

/// Two surfaces, one made from the other. A place of the result corresponds to the nearest one of
/// the original, on its own side: of the same piece and model face, with a normal within 90
/// degrees, and for vertices on rims (edges of other than two faces, listed model edges) on a rim.
/// Both must outlive it. Built in O(n log n).
class SurfacePairing {
 public:
  SurfacePairing(const Cells& original, const Cells& result, const SameVertices& same, int threads);

  /// The place of the original at a point of a face of the result; nothing where it has none.
  [[nodiscard]] SurfacePlace place_at(const glm::dvec3& p, std::uint32_t face) const;
  /// The face alone.
  [[nodiscard]] std::uint32_t face_at(const glm::dvec3& p, std::uint32_t face) const;
  /// What values at the vertices of the result are made of.
  [[nodiscard]] std::vector<VertexSource> vertex_sources() const;

 private:
  /// How a vertex of the result lies in its faces.
  struct VertexSide {
    glm::dvec3 normal{0}, inward{0};
    std::uint32_t face = no_index;  ///< one of its faces
    bool on_rim = false;
  };
  void find_parts();
  [[nodiscard]] std::vector<std::uint32_t> pieces_by_vote(
      const std::vector<std::uint32_t>& pieces) const;
  void find_sides();
  [[nodiscard]] VertexSource source_of(std::uint32_t vertex) const;
  [[nodiscard]] const SidedTree::Item* item_of(std::uint32_t vertex) const;
  [[nodiscard]] const SidedTree::Item* rim_of(std::uint32_t vertex, std::uint32_t part) const;
  [[nodiscard]] VertexSource weighted(const SidedTree::Item& item, const glm::dvec3& p) const;

  const Cells &original_, &result_;
  const SameVertices& same_;
  int threads_;
  SidedTree faces_, rims_;
  std::vector<Side> face_sides_;          ///< of the faces of the result
  std::vector<VertexSide> vertex_sides_;  ///< of its vertices
};

}  // namespace aomd::fields
