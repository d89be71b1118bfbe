#pragma once
// Which classification goes into a result: what the input carried, not what was derived on the way.

#include "core/mesh/mesh_data.h"

namespace aomd::cli {

/// For each kind of entity, says whether the input classified it (edges, and faces of a volume:
/// listed any).
struct GivenClasses {
  bool vertices = false, edges = false, faces = false, regions = false, lists_faces = false;

  explicit GivenClasses(const MeshData& input)
      : vertices(!input.vertex_classes.empty()),
        edges(!input.edges.empty()),
        faces(!input.faces.classes.empty()),
        regions(!input.regions.classes.empty()),
        lists_faces(input.regions.empty() || !input.faces.empty()) {}

  /// Drops from a result what the input did not carry.
  void apply(MeshData& result) const {
    if (!vertices) result.vertex_classes.clear();
    if (!edges) result.edges = {};
    if (!lists_faces) result.faces = {};
    if (!faces) result.faces.classes.clear();
    if (!regions) result.regions.classes.clear();
  }
};

}  // namespace aomd::cli
