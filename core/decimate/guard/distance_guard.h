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
/// distance of what the original has on the same model edge. Of a volume every point of a model
/// face stays within the distance of the same model face, so that an interface is not near because
/// another one is. Not the other way round: that every point of the original has the result near it
/// is for measuring at the end.
class DistanceGuard {
 public:
  /// Copies the original: its triangles, and its edges that lie on model edges. `distance` is a
  /// length, at least 0. O(n log n); about 220 bytes a face.
  DistanceGuard(const Mesh& original, double distance);

  [[nodiscard]] double distance() const { return distance_; }

  /// Accepts where every point of every created face, and of every changed piece of a model edge,
  /// certainly lies within the distance, up to rounding of the coordinates. Else Reason::Distance
  /// with the face (or the vertex, for a model edge) and the distance of a point that is too far;
  /// where the guard cannot tell, of one that is nearly so (see Envelope). 5 to 20 us where the
  /// distance is well above what the operations need, 100 us where it decides.
  [[nodiscard]] Verdict judge(const Change& change);

 private:
  /// What the original has on one model entity; of a surface, all its faces.
  struct Part {
    ModelRef model;
    Envelope near;
  };
  /// A triangle of a part that may be near.
  struct Hint {
    const Part* part = nullptr;
    std::uint32_t triangle = no_index;
  };
  [[nodiscard]] static Part* find(std::vector<Part>& parts, ModelRef model);
  [[nodiscard]] Part* surface_of(const NewFace& f);
  [[nodiscard]] Verdict judge_middles(const Change& change);
  [[nodiscard]] Verdict judge_curves(const Change& change);
  [[nodiscard]] std::uint32_t& hint(Vertex v, const Part& part);

  double distance_;
  bool by_model_face_;                   ///< else one surface stands for all
  std::vector<Part> surfaces_, curves_;  ///< in ascending order
  Column<Vertex, Hint> hints_;
};

}  // namespace aomd
