#pragma once
// Improvement of tetrahedra: passes of edge and face removals and of moves, and mending of the
// worst.

#include <array>
#include <cstdint>
#include <vector>

#include "core/decimate/volume/removals_ahead.h"
#include "core/operators/edge_removal.h"
#include "core/operators/face_removal.h"
#include "core/operators/region_move.h"

namespace aomd {

/// What improving has to respect, and where it looks.
struct ImprovementRules {
  RemovalRules removal;
  MoveRules move;
  double poor = 0.6;  ///< the edges and faces of tetrahedra with a lower tet_shape are judged
};

/// Who has a say beyond the operators, and hears of what is made: what is kept, guards, statistics.
class ImprovementWatch {
 public:
  virtual ~ImprovementWatch() = default;
  /// Asked for a poor tetrahedron before a pass of removals looks at its edges and faces; where
  /// threads judge ahead, by several at once.
  [[nodiscard]] virtual bool looks_at(Region /*poor*/) { return true; }
  /// Asked for what an operator has accepted.
  [[nodiscard]] virtual bool allows(const EdgeRemoval& /*plan*/) { return true; }
  [[nodiscard]] virtual bool allows(const FaceRemoval& /*plan*/) { return true; }
  [[nodiscard]] virtual bool allows(const RegionMove& /*plan*/) { return true; }
  /// Called when it has been made.
  virtual void made(const EdgeRemoval& /*plan*/) {}
  virtual void made(const FaceRemoval& /*plan*/) {}
  virtual void made(const RegionMove& /*plan*/) {}
};

/// Improves one mesh, an operation at a time or a pass at a time. Each makes the worst tetrahedron
/// of those that it changes better, so that passes end. The mesh may change in between. What must
/// be stored: as RegionMover. Allocates nothing once it has held the largest ball.
class VolumeImprovement {
 public:
  VolumeImprovement(Mesh& mesh, const ImprovementRules& rules, ImprovementWatch& watch)
      : mesh_(mesh), rules_(rules), watch_(watch), mover_(mesh) {}

  void set_rules(const ImprovementRules& rules) {
    rules_ = rules;
    ahead_.forget();
  }
  /// So many threads judge removals ahead of their turn; the result is the same.
  void set_threads(int threads) { threads_ = threads; }

  /// Starts a pass over the regions, or vertices, that there are now.
  void begin_pass() {
    cursor_ = 0;
    ahead_.forget();
  }
  /// Goes on to the next region, by id, and replaces it where it is poor: by the edge or face whose
  /// removal gains most. False when there was none left. `made`: whether it did.
  [[nodiscard]] bool next_swap(bool& made);
  /// Goes on to the next vertex, by id.
  [[nodiscard]] bool next_move(bool& made);

  /// Whole passes; each returns how many operations it made.
  std::uint32_t swap_pass();
  std::uint32_t smooth_pass();
  /// Works through the tetrahedra whose shape is below a limit, worst first, and through those that
  /// their mending leaves below it: removals, then moves of their vertices. Returns how many
  /// operations it made.
  std::uint32_t mend(double below);

 private:
  /// A tetrahedron to mend. Out of date where its shape is another by now.
  struct Sliver {
    double shape;
    Region region;
    /// The top of the heap is the worst, of equals the one with the smallest id.
    friend bool operator<(const Sliver& a, const Sliver& b) {
      return a.shape != b.shape ? a.shape > b.shape : b.region < a.region;
    }
  };

  [[nodiscard]] bool is_tetrahedron(Region r) const;
  [[nodiscard]] bool is_poor(Region r) const {
    return is_tetrahedron(r) && tet_shape(mesh_, r) < rules_.poor;
  }
  void look_ahead(Region next);
  bool beats(Vertex a, Vertex b, double& gain);
  bool beats(Region r, std::uint32_t slot, double& gain);
  template <typename Plan>
  void make(const Plan& plan, const std::array<Vertex, 2>& changed);
  bool try_swap(Region r);
  bool try_move(Vertex v);
  bool try_mending(Region r);
  void queue(Region r, double below);
  void queue_changed(double below);

  Mesh& mesh_;
  ImprovementRules rules_;
  ImprovementWatch& watch_;
  RegionMover mover_;
  EdgeRemoval edge_, best_edge_;
  FaceRemoval face_, best_face_;
  RegionMove move_;
  std::array<Vertex, 2>
      changed_;                  ///< all regions that the last operation changed have one of these
  std::vector<Sliver> slivers_;  ///< a heap
  std::uint32_t cursor_ = 0;
  int threads_ = 1;
  RemovalsAhead ahead_;         ///< of a pass, on several threads
  std::uint64_t revision_ = 0;  ///< of the mesh that it knows
};

}  // namespace aomd
