#pragma once
// Tells the edges of a model from the steps of a round that is drawn in facets.

#include <array>
#include <optional>

#include "core/mesh/mesh.h"
#include "core/model/edge_faces.h"

namespace aomd {

/// Judges sharp edges by what is around them. An edge is a step of a round, and so no feature, when
/// the surface goes on turning beyond its faces: the same way, by about as much, and as soon. To
/// see that, a straight walk sets out from the middle of the edge over the faces of each side.
/// docs/CLASSIFICATION.md has the rule in words and the shapes that it was found on. The mesh must
/// store T(2,0), T(2,1).
class FacetJudge {
 public:
  /// From here on an edge is a corner, whatever is around it: fewer than eight to a full turn.
  static constexpr double corner_deg = 50;

  FacetJudge(const Mesh& mesh, const EdgeFaces& faces) : mesh_(mesh), faces_(faces) {}

  /// For an edge of two faces. O(1): a walk ends after at most 24 faces.
  [[nodiscard]] bool is_step(Edge e) const;

 private:
  struct Walk;
  struct Beyond;
  [[nodiscard]] std::optional<std::array<Walk, 2>> set_out(Edge e) const;
  [[nodiscard]] Beyond look(Walk walk, double angle) const;
  [[nodiscard]] bool comes_to_fine_plane(Walk walk, double angle, double width) const;
  [[nodiscard]] bool leave(Walk& walk, Edge& through) const;
  [[nodiscard]] bool go(Walk& walk) const;
  [[nodiscard]] glm::dvec3 into(Face f, std::size_t side, const glm::dvec3& unit) const;

  const Mesh& mesh_;
  const EdgeFaces& faces_;
};

}  // namespace aomd
