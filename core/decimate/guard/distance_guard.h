#pragma once
// The guarantee that a decimated surface stays within a distance of the original.

#include <vector>

#include "core/decimate/guard/envelope.h"
#include "core/decimate/guard/surface_change.h"
#include "core/mesh/column.h"
#include "core/operators/verdict.h"

namespace aomd {

/// Asked before each operation, it keeps every point of the surface within a distance of the
/// original, and every point of a model edge (so of the boundary of a classified mesh) within that
/// distance of what the original has on the same model edge. Not the other way round: that every
/// point of the original has the result near it is for measuring at the end.
class DistanceGuard {
 public:
  /// Copies the original: its triangles, and its edges that lie on model edges. `distance` is a
  /// length, at least 0. O(n log n); about 220 bytes a face.
  DistanceGuard(const Mesh& original, double distance);

  [[nodiscard]] double distance() const { return surface_.distance(); }

  /// Accepts where every point of every created face, and of every changed piece of a model edge,
  /// certainly lies within the distance, up to rounding of the coordinates. Else Reason::Distance
  /// with the face (or the vertex, for a model edge) and the distance of a point that is too far;
  /// where the guard cannot tell, of one that is nearly so (see Envelope). 5 to 20 us where the
  /// distance is well above what the operations need, 100 us where it decides.
  [[nodiscard]] Verdict judge(const Change& change);

 private:
  [[nodiscard]] Verdict judge_curves(const Change& change);
  [[nodiscard]] std::uint32_t& hint(Vertex v);

  Envelope surface_;
  struct Curve {
    ModelRef model;
    Envelope pieces;
  };
  std::vector<Curve> curves_;            ///< in ascending order
  Column<Vertex, std::uint32_t> hints_;  ///< a triangle of the original that may be near the vertex
};

}  // namespace aomd
