#pragma once
// The faceted original as a model: what snapping uses where there is no CAD model.

#include "core/mesh/mesh.h"
#include "core/model/model.h"
#include "core/model/triangle_tree.h"

#pragma GCC visibility push(default)

namespace aomd {

/// A modeler over the faces, edges and vertices of a classified mesh, grouped by the model entity
/// that they are classified on. Closest points are exact over the facets, and faces end at their
/// borders; about O(log n). The normal is that of the nearest facet. No parametrisations.
class DiscreteModel final : public Model {
 public:
  /// Copies the geometry: the mesh may change or go afterwards. Creates the edges when the mesh has
  /// none. O(n log n); about 170 bytes a facet. Entities that are unclassified, and faces on model
  /// regions, are no part of it.
  explicit DiscreteModel(Mesh& mesh);

 private:
  [[nodiscard]] ClosestPoint closest_on(std::size_t index, const glm::dvec3& point) const override;
  [[nodiscard]] glm::dvec3 normal_of(std::size_t index, const glm::dvec3& point) const override;
  [[nodiscard]] std::optional<ParameterRange> range_of(std::size_t) const override { return {}; }
  [[nodiscard]] glm::dvec3 evaluate_at(std::size_t, const glm::dvec2&) const override { return {}; }
  [[nodiscard]] Box box_of(std::size_t index) const override { return facets_[index].box(); }

  /// By entity. A segment of a model edge is a triangle (a, b, b), a model vertex (a, a, a).
  std::vector<TriangleTree> facets_;
};

}  // namespace aomd

#pragma GCC visibility pop
