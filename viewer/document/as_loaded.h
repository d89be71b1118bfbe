#pragma once
// The mesh as it was loaded, kept beside the one that is decimated: what results are held against.

#include <map>
#include <optional>

#include "core/mesh/column.h"
#include "core/model/triangle_tree.h"
#include "viewer/document/beside_mesh.h"

namespace aomd::scene {

/// Vertices and faces have the ids that they have in the document's mesh at the start of its
/// history. Not movable. What is measured is made at the first need.
class AsLoaded {
 public:
  /// Of a mesh that is at the start of its history. O(size).
  explicit AsLoaded(const Mesh& mesh);

  /// Of a surface it stores T(2,0), T(0,1), T(0,2).
  [[nodiscard]] const Mesh& mesh() const { return copy_.mesh(); }
  /// Whether a face of a later state is still the one of this id here.
  [[nodiscard]] bool has(const Mesh& mesh, Face face) const;
  /// Of a surface.
  [[nodiscard]] const TriangleTree& tree();
  /// Of a volume: what its skin has on a model face; null where that is nothing.
  [[nodiscard]] const TriangleTree* tree_of(ModelRef model_face);
  [[nodiscard]] const Column<Vertex, double>& curvatures();

 private:
  void plant_skin();

  BesideMesh copy_;
  std::optional<TriangleTree> tree_;
  std::map<ModelRef, TriangleTree> skin_trees_;  ///< by model face; empty before the first need
  std::optional<Column<Vertex, double>> curvatures_;
};

/// The largest distance of a face of `mesh` to `original`, at the 15 points of a regular lattice
/// over it.
[[nodiscard]] double face_distance(const Mesh& mesh, Face face, const TriangleTree& original);

}  // namespace aomd::scene
