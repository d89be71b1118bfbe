#pragma once
// What a feature angle would lead to, without classifying anything.

#include <vector>

#include "core/model/classify.h"

namespace aomd {

/// The edges that would lie on model edges, and how many model entities they would make.
struct FeaturePreview {
  std::vector<Edge> edges;
  int model_edges = 0, model_vertices = 0;
};

/// Counts what classify() would make of a surface of triangles on which nothing is classified,
/// whatever is. The mesh must store T(0,1), T(2,0), T(2,1). O(entities).
[[nodiscard]] FeaturePreview preview_features(const Mesh& mesh, const ClassifyOptions& options);

}  // namespace aomd
