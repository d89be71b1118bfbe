#pragma once
// What the strategies of a decimation have in common: a loop that advances by one candidate at a
// time.

#include <functional>
#include <optional>
#include <vector>

#include "core/decimate/explain/outlook.h"
#include "core/decimate/guard/guards.h"
#include "core/decimate/options.h"
#include "core/operators/edge_removal.h"
#include "core/operators/region_collapse.h"
#include "core/operators/region_move.h"

namespace aomd {

/// An operation that a loop has judged: what the operator needs to make it, and what the guards are
/// told then. Each of its kinds has its own part. Reused, it allocates nothing.
struct Plan {
  VolumeCollapsePlan collapse;  ///< on a surface without balls
  EdgePair pair;                ///< a swap
  EdgeRemoval removal;          ///< the same among tetrahedra
  struct {
    glm::dvec3 target{0.0};
    Star star;
  } move;                  ///< of a vertex that is smoothed: where to, and the faces around it
  RegionMove region_move;  ///< the same among tetrahedra
  Change change;
};

/// One strategy at work on one mesh. Stops between two operations only; the mesh must not change
/// otherwise, except through invalidate().
class Loop {
 public:
  Loop(Mesh& mesh, const DecimationOptions& options)
      : mesh_(mesh), options_(options), guards_(mesh, options) {}
  virtual ~Loop() = default;
  Loop(const Loop&) = delete;
  Loop& operator=(const Loop&) = delete;

  /// Looks at one candidate; true when that led to an operation (last()).
  virtual bool advance() = 0;
  /// Makes what several threads can make at once before advance() has to go on; false where that is
  /// nothing. The result is the same without. Stops when `cancelled`, asked every few candidates.
  virtual bool advance_parts(const std::function<bool()>& cancelled) {
    (void)cancelled;
    return false;
  }
  /// New options, or a mesh that was changed from outside: forgets what it knows and starts again.
  virtual void restart(const DecimationOptions& options) = 0;
  /// One pass of swaps, or of smoothing, now, whatever the phase. Returns how many operations it
  /// made.
  virtual std::uint32_t swap_pass() = 0;
  virtual std::uint32_t smooth_pass() = 0;
  /// Judges an edge as the loop would: the end that may go, or the refusal that got furthest.
  [[nodiscard]] virtual Verdict judge(Edge edge, Vertex& deleted) = 0;
  /// Judges the edge between two vertices, which need not be an entity for Quality.
  [[nodiscard]] virtual Verdict judge(Vertex a, Vertex b) = 0;
  /// What would become of an edge, for each way in which the loop may collapse it. Changes nothing.
  [[nodiscard]] virtual std::vector<CollapseOutlook> outlook(Edge edge) = 0;
  /// What swapping an edge and smoothing a vertex would come to; none where the loop could not tell
  /// now.
  [[nodiscard]] virtual std::optional<SwapOutlook> swap_outlook(Edge edge) = 0;
  [[nodiscard]] virtual std::optional<MoveOutlook> move_outlook(Vertex v) = 0;
  /// Why an edge was not collapsed when it was last judged (None: not judged yet).
  [[nodiscard]] virtual Reason last_refusal(Edge e) const = 0;
  /// The spacing at a vertex; infinite where nothing limits it.
  [[nodiscard]] virtual double spacing(Vertex v) const = 0;
  /// A guess in [0,1].
  [[nodiscard]] virtual double progress() const = 0;
  /// What it knows of the surface that it started from; nothing where it holds no points.
  [[nodiscard]] virtual OriginalSamples original() { return {}; }

  [[nodiscard]] const DecimationOptions& options() const { return options_; }
  [[nodiscard]] Phase phase() const { return phase_; }
  [[nodiscard]] bool done() const { return phase_ == Phase::Done; }
  [[nodiscard]] const Operation& last() const { return last_; }
  [[nodiscard]] const std::vector<SweepStatistics>& sweeps() const { return sweeps_; }

 protected:
  /// Opens the statistics of a new sweep, unless the present ones are still empty.
  void open_sweep() {
    const bool unused = !sweeps_.empty() && sweeps_.back() == SweepStatistics{};
    if (unused) return;
    if (!sweeps_.empty()) close_sweep();
    sweeps_.emplace_back();
  }
  /// Notes what the sweep has left of the mesh.
  void close_sweep() {
    sweeps_.back().faces = mesh_.count(2);
    sweeps_.back().regions = mesh_.count(3);
  }
  /// Whether a swap would change a face that stays.
  [[nodiscard]] bool keeps_face_of(const EdgePair& e) const {
    return options_.kept(e.a, e.b, e.c) || options_.kept(e.b, e.a, e.d);
  }
  /// Counts an operation that was judged and made, and tells the guards.
  void made(StepKind kind, EntityRef entity, const Change& change) {
    sweeps_.back().count(kind);
    last_ = {kind, entity};
    guards_.applied(change);
  }

  Mesh& mesh_;
  DecimationOptions options_;
  Guards guards_;
  Phase phase_ = Phase::Collapse;
  std::vector<SweepStatistics> sweeps_;
  Operation last_;
  Plan plan_;  ///< of the operation that is judged to be made; who only looks has another
};

}  // namespace aomd
