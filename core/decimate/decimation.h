#pragma once
// The driver (paper, section 3 and figure 7): sweeps of edge collapses driven by a spacing field, improved by
// swaps and smoothing, until nothing more collapses. Resumable: it stops between two operations only.

#include <array>
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "core/mesh/column.h"
#include "core/mesh/journal.h"
#include "core/mesh/mesh.h"
#include "core/model/model.h"
#include "core/operators/collapse.h"
#include "core/operators/swap.h"
#include "core/operators/verdict.h"

namespace aomd {

struct DecimationOptions {
  double factor = 4;      ///< how many times longer edges become where the angle does not bind
  bool coarsest = false;  ///< no limit on length; `factor` is then ignored
  double angle_deg = 10;  ///< how far the normal of a face may turn in one operation, degrees
  TopologyRule topology = TopologyRule::Safe;
  int improve_passes = 2;  ///< sweeps that are followed by swaps and smoothing
  bool swap = true;
  bool smooth = true;
  /// Smoothing puts vertices onto it; none: it does not. Not owned; must have every entity that the mesh lies
  /// on (check_against) and outlive the decimation.
  const Model* model = nullptr;

  friend bool operator==(const DecimationOptions&, const DecimationOptions&) = default;
};

/// What one sweep and the improvement after it did. `refused` counts the edges that the sweep left, by
/// reason.
struct SweepStatistics {
  std::uint32_t collapses = 0, swaps = 0, smooths = 0;
  std::uint32_t faces = 0;  ///< after it
  std::array<std::uint32_t, reason_count> refused{};

  friend bool operator==(const SweepStatistics&, const SweepStatistics&) = default;
};

enum class Phase : std::uint8_t { Collapse, Swap, Smooth, Done };
[[nodiscard]] const char* phase_name(Phase phase);

/// The last operation made: what step() returns.
struct Operation {
  StepKind kind = StepKind::Edit;
  EntityRef entity;
};

/// Why a mesh cannot be decimated, as a sentence; null where it can: it has no regions, and its faces are
/// triangles. O(faces).
[[nodiscard]] const char* decimation_obstacle(const Mesh& mesh);

/// Decimates one mesh. Holds T(0,1), T(0,2), T(2,0) stored while it lives; they go with it.
/// The mesh must not change otherwise while it lives, except through invalidate().
class Decimation {
 public:
  /// Throws std::invalid_argument where there is an obstacle (above).
  explicit Decimation(Mesh& mesh, const DecimationOptions& options = {});

  [[nodiscard]] const DecimationOptions& options() const { return options_; }
  /// Takes new options at any time; the next sweep starts at the first edge and judges everything again.
  void set_options(const DecimationOptions& options);
  /// The mesh was changed from outside (undo, say): forget remembered verdicts and start a new sweep.
  /// Vertices that are new since construction have spacing 0: they stay.
  void invalidate();

  /// One operation, whatever its kind; none when done.
  std::optional<Operation> step();
  /// To the end of the present sweep of collapses. Returns how many it made.
  std::uint32_t sweep();
  /// One pass of swaps, of smoothing, or of both, now, whatever the phase. Returns how many operations it
  /// made.
  std::uint32_t swap_pass();
  std::uint32_t smooth_pass();
  std::uint32_t improve() { return swap_pass() + smooth_pass(); }

  enum class Stop { Done, Budget, Cancelled };
  /// Runs until done, until `budget` of time is spent (checked every few operations), or until `cancelled`
  /// says so.
  Stop run(std::optional<std::chrono::microseconds> budget = {}, const std::function<bool()>& cancelled = {});

  [[nodiscard]] Phase phase() const { return phase_; }
  [[nodiscard]] bool done() const { return phase_ == Phase::Done; }
  /// A guess in [0,1]: each sweep is taken for half of what is left.
  [[nodiscard]] double progress() const;
  [[nodiscard]] const std::vector<SweepStatistics>& sweeps() const { return sweeps_; }
  /// The wanted length at a vertex: average length of its edges at the start, times factor. Infinite for
  /// coarsest.
  [[nodiscard]] double spacing(Vertex v) const;
  /// Why the edge was not collapsed when it was last judged (None: not judged yet).
  [[nodiscard]] Reason last_refusal(Edge e) const { return refusal_[e]; }
  /// Judges an edge as the sweep would: the first end that may go, or the refusal that got furthest.
  [[nodiscard]] Verdict judge(Edge edge, Vertex& deleted);

 private:
  [[nodiscard]] CollapseRules rules() const { return {limit_, options_.topology}; }
  void fill_spacing();
  bool advance();  // one candidate; true when it led to an operation
  bool try_collapse(Edge edge);
  bool try_swap(Edge edge);
  bool try_smooth(Vertex v);
  void touch(Vertex v) { changed_[v] = now_; }
  [[nodiscard]] bool unchanged_since(Edge e) const;
  void begin_sweep();
  void end_sweep();
  void next_phase();
  [[nodiscard]] std::uint32_t end_of_phase() const;

  Mesh& mesh_;
  DecimationOptions options_;
  TurnLimit limit_;
  std::array<Request, 3> needs_;
  Collapser collapser_;
  Column<Vertex, double> average_length_;
  Column<Vertex, std::uint32_t> changed_;  ///< value of now_ when the vertex's surroundings last changed
  Column<Edge, std::uint32_t> judged_;     ///< value of now_ when the edge was last refused
  Column<Edge, Reason> refusal_;
  std::uint32_t now_ = 1;
  Phase phase_ = Phase::Collapse;
  std::uint32_t cursor_ = 0;
  int improved_ = 0;
  std::vector<SweepStatistics> sweeps_;
  Operation last_;
};

}  // namespace aomd
