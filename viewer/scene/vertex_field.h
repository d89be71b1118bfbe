#pragma once
// A number at each vertex as colours.

#include <limits>
#include <memory>

#include "core/mesh/column.h"
#include "core/mesh/mesh.h"
#include "viewer/scene/palette.h"

namespace aomd::scene {

/// Colours of the values, and what the legend needs. The scale is logarithmic, from the smallest to the
/// largest value; what is not positive and finite is plain and does not count. There may be none.
struct VertexField {
  double low = std::numeric_limits<double>::infinity(), high = 0;
  std::shared_ptr<const Column<Vertex, Color>> colors;

  [[nodiscard]] bool empty() const { return low > high; }
};

/// O(vertices).
[[nodiscard]] VertexField make_vertex_field(const Mesh& mesh, const Column<Vertex, double>& values);

}  // namespace aomd::scene
