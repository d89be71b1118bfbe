#pragma once
// The guarantee that a decimated volume stays near all of its original: the other half of what
// DistanceGuard holds.

#include <cstdint>
#include <vector>

#include "core/decimate/guard/covered_cells.h"
#include "core/decimate/guard/surface_change.h"
#include "core/operators/verdict.h"

namespace aomd {

/// Asked before each operation and told of each that was made, it keeps every point that the
/// original has on a model face, or a model edge, within a distance of the same one in the result.
class Coverage {
 public:
  /// Copies the faces and edges on the model. T(2,0) must be stored. O(n); about 180 bytes for
  /// each.
  Coverage(const Mesh& original, double distance);
  /// The mesh was changed from outside.
  void restart(const Mesh& mesh);

  /// Accepts where all that the replaced faces and pieces stand for is near what takes their place,
  /// or what stays around the vertex; what was further off before may stay as far. Else
  /// Reason::Distance with a face, or the vertex of a model edge, and the distance. About 5 us.
  [[nodiscard]] Verdict judge(const Change& change);
  /// The operation was made.
  void applied(const Change& change);

 private:
  void gather(const Change& change);

  CoveredCells on_faces_, on_edges_;
  std::vector<ModelCell> faces_, edges_;  ///< that may stand for points after the change
  std::vector<std::uint32_t> old_faces_, old_edges_;
};

}  // namespace aomd
