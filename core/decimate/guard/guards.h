#pragma once
// The guarantees that a decimation was asked for, as one thing that a loop asks before each
// operation.

#include <memory>

#include "core/decimate/guard/coverage.h"
#include "core/decimate/guard/distance_guard.h"
#include "core/decimate/guard/intersection_guard.h"
#include "core/decimate/guard/surface_change.h"
#include "core/decimate/options.h"

namespace aomd {

/// Holds the guards that the options name; with none, asking costs a comparison.
class Guards {
 public:
  /// Takes `mesh` for the original. O(n log n) for each guard.
  Guards(const Mesh& mesh, const DecimationOptions& options) { restart(mesh, options); }

  /// The mesh was changed from outside, or the options were. The distance stays that to the first
  /// original, unless another one is asked for: then it is measured from the mesh as it is now.
  void restart(const Mesh& mesh, const DecimationOptions& options) {
    if (options.max_distance <= 0) {
      distance_.reset();
      coverage_.reset();
    } else if (!distance_ || distance_->distance() != options.max_distance) {
      distance_ = std::make_unique<DistanceGuard>(mesh, options.max_distance);
      if (mesh.count(3) > 0) coverage_ = std::make_unique<Coverage>(mesh, options.max_distance);
    } else if (coverage_) {
      coverage_->restart(mesh);
    }
    intersections_ = options.no_intersections ? std::make_unique<IntersectionGuard>(mesh) : nullptr;
  }

  [[nodiscard]] bool any() const { return distance_ || intersections_; }

  /// Judges what an operator has accepted: a contraction with the faces around both ends, a pair of
  /// faces, or a vertex with the faces around it and where it goes. `change` receives what it comes
  /// to, where there is a guard to be told. What changes more faces than the stars of two vertices
  /// that are not crowded is refused: each new face is held against all others.
  template <typename... Operation>
  [[nodiscard]] Verdict judge(const Mesh& mesh, Change& change, const Operation&... operation) {
    if (!any()) return {};
    describe(mesh, operation..., change);
    if (change.created.size() > 2 * largest_star)
      return {distance_ ? Reason::Distance : Reason::Intersection, change.created[0].face};
    Verdict verdict = distance_ ? distance_->judge(change) : Verdict();
    if (verdict.accepted() && coverage_) verdict = coverage_->judge(change);
    if (verdict.accepted() && intersections_) verdict = intersections_->judge(change);
    return verdict;
  }

  /// The operation that judge() described has been made.
  void applied(const Change& change) {
    if (coverage_) coverage_->applied(change);
    if (intersections_) intersections_->applied(change);
  }

 private:
  std::unique_ptr<DistanceGuard> distance_;
  std::unique_ptr<Coverage> coverage_;  ///< of a volume, with the distance
  std::unique_ptr<IntersectionGuard> intersections_;
};

}  // namespace aomd
