#pragma once
// The driver (paper, section 3 and figure 7): sweeps of edge collapses driven by a spacing field,
// improved by swaps and smoothing, until nothing more collapses. Resumable: it stops between two
// operations only.

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/decimate/explain/outlook.h"
#include "core/decimate/options.h"
#include "core/mesh/mesh.h"

#pragma GCC visibility push(default)

namespace aomd {

class Loop;

/// Whether a mesh has regions that are tetrahedra: of volumes nothing else is decimated.
/// O(regions).
[[nodiscard]] bool has_tetrahedra(const Mesh& mesh);

/// Why a mesh cannot be decimated, as a sentence; null where it can: it has tetrahedra, or no
/// regions and faces that are triangles, and its box is between 1e-20 and 1e+18 across. O(size).
[[nodiscard]] const char* decimation_obstacle(const Mesh& mesh);

/// Lets go of all edges but those on model edges (Mesh::keep_model_edges_only), which Quality needs
/// no others than, nor Paper on a surface, where nobody asks for the others as entities. All stay
/// where that would gain nothing, since all are on model edges, or where a model edge has no face
/// and could not be found any more. The number of edges that are left tells whether it did, for
/// journals that start from there. O(entities).
void keep_edges_for_quality(Mesh& mesh);

/// Decimates one mesh by either strategy. Holds T(2,0) and T(0,2) stored while it lives, T(0,1) too
/// where the mesh has other edges than those on model edges; with DecimationOptions::exchange Paper
/// holds T(2,0) and T(1,0), and what the present phase needs. On a volume T(3,0), T(0,3), T(1,0)
/// and T(0,1), and T(2,0) and T(0,2) as listed. They go with it. The mesh must not change otherwise
/// while it lives, except through invalidate(). Operation::entity is the edge that was collapsed or
/// swapped where all edges are entities, else the vertex that was kept, or a face at the edge.
class Decimation {
 public:
  /// Throws std::invalid_argument where there is an obstacle (above), and where a vertex lies on a
  /// model entity of higher dimension than what it bounds: classify() comes before a decimation.
  explicit Decimation(Mesh& mesh, DecimationOptions options = {});
  ~Decimation();

  enum class Stop { Done, Budget, Cancelled };

  /// As given, but for the points of the original.
  [[nodiscard]] const DecimationOptions& options() const { return given_; }
  /// Takes new options at any time; everything is judged again. Another strategy starts from the
  /// mesh as it is.
  void set_options(const DecimationOptions& options);
  /// The mesh was changed from outside (undo, say): forget remembered verdicts and start a new
  /// sweep. Vertices that are new since construction have spacing 0: they stay.
  void invalidate();

  /// One operation, whatever its kind; none when done.
  std::optional<Operation> step();
  /// To the end of the present sweep of collapses. Returns how many it made.
  std::uint32_t sweep();
  /// To the end of the present phase, or until `cancelled` says so, asked every few candidates.
  Stop run_phase(const std::function<bool()>& cancelled = {});
  /// One pass of swaps, of smoothing, or of both, now, whatever the phase. Returns how many
  /// operations it made.
  std::uint32_t swap_pass();
  std::uint32_t smooth_pass();
  std::uint32_t improve() { return swap_pass() + smooth_pass(); }

  /// Runs until done, until `budget` of time is spent (checked every few operations), or until
  /// `cancelled` says so.
  Stop run(std::optional<std::chrono::microseconds> budget = {},
           const std::function<bool()>& cancelled = {});

  [[nodiscard]] Phase phase() const;
  [[nodiscard]] bool done() const { return phase() == Phase::Done; }
  /// A guess in [0,1].
  [[nodiscard]] double progress() const;
  [[nodiscard]] const std::vector<SweepStatistics>& sweeps() const;
  /// The spacing at a vertex: what the options give, else the average length of its edges at the
  /// start, times factor. Infinite for coarsest.
  [[nodiscard]] double spacing(Vertex v) const;
  /// Why the edge was not collapsed when it was last judged (None: not judged yet).
  [[nodiscard]] Reason last_refusal(Edge e) const;
  /// Judges an edge as the loop would: the end that may go, or the refusal that got furthest.
  [[nodiscard]] Verdict judge(Edge edge, Vertex& deleted);
  /// How many edges each reason keeps now, which takes a few microseconds an edge. For Paper on
  /// large meshes what its last sweep counted, before swaps and smoothing.
  [[nodiscard]] EdgesByReason edges_left();
  /// What would become of an edge, for each way in which the strategy may collapse it: each end for
  /// Paper, one for Quality. core/decimate/explanation.h puts it into words. Changes nothing.
  [[nodiscard]] std::vector<CollapseOutlook> outlook(Edge edge);
  /// What swapping an edge and smoothing a vertex would come to. None while Quality collapses: it
  /// judges them by where the original's points lie, which it finds out after that.
  [[nodiscard]] std::optional<SwapOutlook> swap_outlook(Edge edge);
  [[nodiscard]] std::optional<MoveOutlook> move_outlook(Vertex v);
  /// Of Quality on a surface: the points of the original that it holds, each with the face that is
  /// nearest now, so that another decimation can go on from the mesh as it is
  /// (DecimationOptions::original). Nothing for others. O(points).
  [[nodiscard]] OriginalSamples original();

 private:
  void begin(DecimationOptions options);
  void begin_volume(const DecimationOptions& options);
  [[nodiscard]] DecimationOptions for_loop(const DecimationOptions& options) const;

  Mesh& mesh_;
  DecimationOptions given_;
  std::vector<Request> needs_;
  std::unique_ptr<Loop> loop_;
};

}  // namespace aomd

#pragma GCC visibility pop
