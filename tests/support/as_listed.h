#pragma once
// How tests classify data whose faces they put on model faces themselves, and which edges they
// keep.

#include "core/mesh/mesh_data.h"
#include "core/model/classify.h"

namespace aomd::test {

/// Which edges are entities.
enum class Edges { All, OnModelEdges };

/// Where faces are classified, no angle has a say beside them.
inline ClassifyOptions as_listed(const MeshData& data) {
  ClassifyOptions how;
  if (!data.faces.classes.empty()) how.feature_angle_deg.reset();
  return how;
}

}  // namespace aomd::test
