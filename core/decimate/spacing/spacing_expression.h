#pragma once
// A wanted edge length as a formula.

#include <memory>
#include <string>

#include "core/decimate/spacing/vertex_neighbours.h"
#include "core/mesh/column.h"
#include "core/mesh/mesh.h"

namespace aomd {

/// A formula over the position of a vertex (x, y, z), the mean length of its edges (h), the
/// curvature of the surface there (k, in 1 / length; see vertex_curvatures) and the diagonal of the
/// mesh's box (diag), with the operators and functions of muparser: `0.02 + 0.1 * abs(z)`, `x < 0 ?
/// 4 * h : 8 * h`, `min(sqrt(0.004 * diag / k), 0.1 * diag)`.
class SpacingExpression {
 public:
  /// Throws std::invalid_argument for what is no formula: one line with the character, counted from
  /// 1, and the reason.
  explicit SpacingExpression(std::string text);
  ~SpacingExpression();
  SpacingExpression(SpacingExpression&&) noexcept;
  SpacingExpression& operator=(SpacingExpression&&) noexcept;

  /// The value at each vertex with edges, 0 at others. O(entities); curvature is found only where
  /// the formula names k. Throws std::invalid_argument naming the first vertex whose value is not
  /// positive and finite.
  [[nodiscard]] Column<Vertex, double> evaluate(const Mesh& mesh,
                                                const VertexNeighbours& neighbours);

 private:
  struct Parser;
  [[noreturn]] void fail_at(const Mesh& mesh, Vertex v, double value) const;

  std::string text_;
  std::unique_ptr<Parser> parser_;
};

}  // namespace aomd
