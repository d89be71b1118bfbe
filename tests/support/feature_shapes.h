#pragma once
// Shapes in few triangles whose model edges are known: each face says on which face of the smooth
// shape it lies.

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/mesh/mesh_data.h"

namespace aomd::test {

struct FeatureShape {
  std::string name;
  MeshData data;  ///< its faces are classified by the smooth shape
};

/// All of them, the same on every machine.
[[nodiscard]] std::vector<FeatureShape> feature_shapes();

}  // namespace aomd::test
