#pragma once
// What a decimation is told, and what it says it did.

#include <array>
#include <cstdint>
#include <limits>
#include <memory>

#include "core/decimate/counted_values.h"
#include "core/decimate/original_samples.h"
#include "core/mesh/column.h"
#include "core/mesh/journal.h"
#include "core/mesh/mesh.h"
#include "core/model/model.h"
#include "core/operators/collapse.h"
#include "core/operators/verdict.h"

#pragma GCC visibility push(default)

namespace aomd {

/// Paper: the printed loop. Quality: collapses in the order of the error they make, the kept vertex
/// placed, then swaps and a fit to the original surface (docs/QUALITY.md).
enum class Strategy : std::uint8_t { Paper, Quality };

/// What the quality strategy does beyond plain ordered collapses, swaps and smoothing; each can be
/// left out, to see what it is worth (tools/bench/quality_ideas.sh).
enum class Idea : std::uint8_t {
  Placement,    ///< the kept vertex goes where the error is least
  ThirdPowers,  ///< few large errors count more than many small ones
  Facing,       ///< no face looks away from the original around its corners
  SecondStage,  ///< the last collapses follow errors that were measured anew
  FarPoints,    ///< the fit cares more for points that are far off
  DensePoints,  ///< below regularity 0.5, where fewer than 8 vertices, those in flat places left
                ///< out, come to each face of the result: the original has a point in each face too
};
inline constexpr int idea_count = 6;
/// "placement", "third-powers", "facing", "second-stage", "far-points", "dense-points".
[[nodiscard]] const char* idea_name(Idea idea);

/// The angle that suits a strategy: 10 degrees where it is what limits, 60 for quality, whose faces
/// are held against the original too.
[[nodiscard]] double usual_angle_deg(Strategy strategy, bool coarsest);

struct DecimationOptions {
  Strategy strategy = Strategy::Paper;
  double factor = 4;      ///< how many times longer edges become where the angle does not bind
  bool coarsest = false;  ///< no limit on length; `factor` is then ignored
  /// Wanted length of edges by vertex, in the mesh's units, instead of factor times the average;
  /// none: factor.
  std::shared_ptr<const Column<Vertex, double>> spacing = {};
  /// Stop at this many faces, of a volume tetrahedra; 0: nothing but spacing and limits stop it.
  std::uint32_t target_faces = 0;
  double angle_deg = 10;  ///< how far the normal of a face may turn in one operation, degrees
  double min_angle_deg =
      0;  ///< no face gets an angle below it unless it had a smaller one, degrees
  double min_dihedral_deg = 0;  ///< of a volume: no tetrahedron gets an angle between two faces
                                ///< below it unless one as bad was around it, degrees
  double regularity = 0.5;      ///< Quality: 0 accuracy first .. 1 regular faces first
  std::uint32_t without = 0;    ///< Quality: bit i leaves out Idea i
  /// Every point of the result within it of the original, and every point of a model edge within it
  /// of that model edge, in the mesh's units; 0: no such guarantee.
  double max_distance = 0;
  /// Quality, of a volume: vertices go where no model region's volume changes, and what cannot be
  /// helped comes to 0.1 % of it at most. Paper places no vertex and keeps no volume; with a model
  /// to snap to, volumes are what that makes of them.
  bool keep_volumes = true;
  bool no_intersections = false;  ///< no operation adds a pair of faces that cut each other
  TopologyRule topology = TopologyRule::Safe;
  int improve_passes = 4;  ///< Paper: sweeps that are followed by swaps and smoothing
  /// Paper: T(0,2) makes way for T(0,1) and T(1,2) while edges are swapped and vertices smoothed,
  /// and comes back for the next collapses, which find edges through a hash set. Off: T(0,1) and
  /// T(0,2) stay. The result is the same (docs/REPRESENTATIONS.md).
  bool exchange = false;
  bool swap = true;
  bool smooth = true;
  int threads = 1;  ///< used wherever there is something to share out; the result is the same
  /// Of a surface, or a volume by Quality: into how many parts it is cut, which take their turns
  /// (docs/PARTS.md); the result depends on it, by next to nothing. 0: what suits the number of
  /// faces or regions, which is one part below 200,000 for Quality, 250,000 for Paper.
  int parts = 0;
  /// Vertices (nonzero) that stay where they are, and so do faces between three of them; none: all
  /// may go.
  std::shared_ptr<const Column<Vertex, std::uint8_t>> keep = {};
  /// Quality, of a surface: nothing collapses into vertices that are kept either. Without swaps no
  /// edge between two of them is new then, and pieces of a surface fit together again where they
  /// have been cut.
  bool seal_kept = false;
  /// Quality, of a surface: numbers on its vertices, as it is when the decimation is made, that
  /// the result is to keep beside its shape; none: the shape alone counts.
  std::shared_ptr<const CountedValues> values = {};
  /// Quality, of a surface: points of what the mesh, as it is when the decimation is made, stands
  /// for already; none: the mesh is the original. Who decimates lets go of them once it has copied
  /// them.
  std::shared_ptr<const OriginalSamples> original = {};
  /// Smoothing puts vertices onto it; none: it does not. Not owned; must have every entity that the
  /// mesh lies on (check_against) and outlive the decimation.
  const Model* model = nullptr;

  friend bool operator==(const DecimationOptions&, const DecimationOptions&) = default;

  [[nodiscard]] DecimationOptions without_original() const {
    DecimationOptions rest = *this;
    rest.original = nullptr;
    return rest;
  }
  [[nodiscard]] bool has(Idea idea) const { return !(without >> static_cast<int>(idea) & 1u); }
  [[nodiscard]] bool kept(Vertex v) const {
    return keep && v.index < keep->size() && (*keep)[v] != 0;
  }
  [[nodiscard]] bool kept(Vertex a, Vertex b, Vertex c) const {
    return kept(a) && kept(b) && kept(c);
  }
};

/// What one sweep and the improvement after it did. `refused` counts the edges that the sweep left,
/// by reason.
struct SweepStatistics {
  std::uint32_t collapses = 0, swaps = 0, smooths = 0;
  std::uint32_t faces = 0, regions = 0;  ///< after it
  std::array<std::uint32_t, reason_count> refused{};

  void count(StepKind made) {
    ++(made == StepKind::Collapse ? collapses : made == StepKind::Swap ? swaps : smooths);
  }
  /// Adds what was made and refused; what is left of the mesh stays.
  SweepStatistics& operator+=(const SweepStatistics& other) {
    collapses += other.collapses;
    swaps += other.swaps;
    smooths += other.smooths;
    for (std::size_t i = 0; i < refused.size(); ++i) refused[i] += other.refused[i];
    return *this;
  }
  friend bool operator==(const SweepStatistics&, const SweepStatistics&) = default;
};

/// How many edges each reason keeps, by Reason; None: nothing is against them.
using EdgesByReason = std::array<std::int64_t, reason_count>;

enum class Phase : std::uint8_t { Collapse, Swap, Smooth, Done };
[[nodiscard]] const char* phase_name(Phase phase);

/// The last operation made: what step() returns.
struct Operation {
  StepKind kind = StepKind::Edit;
  EntityRef entity;
};

}  // namespace aomd

#pragma GCC visibility pop
