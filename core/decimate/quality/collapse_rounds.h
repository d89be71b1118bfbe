#pragma once
// In which order the parts of a surface take their turns, so that the error is spread as by one.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/decimate/quality/collapse_queue.h"
#include "core/parts/partition.h"

namespace aomd {

/// All parts work off the same bucket of costs, each its own vertices in the order of ids; what
/// lies on the seam waits until all have done so, and then has its turn in the order of ids. Then
/// comes the next bucket. Far above the target it is many buckets at once, so that what a part
/// works on stays in the caches; where the target is near, each part may take away its share of the
/// faces that are left to go. One part is the plain queue. What the parts do within a round does
/// not depend on each other: they may do it one after the other or at once.
class CollapseRounds {
 public:
  CollapseRounds(const Mesh& mesh, CollapseQueue& queue, const Partition& parts)
      : mesh_(mesh), queue_(queue), partition_(parts) {}

  /// The queue was filled anew, to be worked off until so many faces are left (0: to its end).
  void begin(std::uint32_t goal);
  /// The vertex whose turn it is, which leaves the queue; an invalid one at the end.
  [[nodiscard]] Vertex next();
  /// Whether that is a part's turn, which must not touch the seam; and which part's.
  [[nodiscard]] bool in_part() const { return turn_ < parts_.size(); }
  [[nodiscard]] std::size_t part() const { return turn_; }

  /// For threads that take the parts' turns at once: whether there is something to share out. What
  /// is left of a round is then taken part by part, from part() on, and ended.
  [[nodiscard]] bool ready();
  [[nodiscard]] Vertex next_of(std::size_t part);
  void end_parts();

  /// What a part has left on the seam, for who comes after; and how many faces it has taken away.
  void leave(std::size_t part, Vertex v) { parts_[part].left.push_back(v); }
  void took(std::size_t part, std::size_t faces) { parts_[part].taken += faces; }

 private:
  /// A part within a round.
  struct alignas(64) Part {
    std::uint64_t share = 0;  ///< of the faces that may go
    std::uint64_t taken = 0;  ///< that have gone
    std::vector<Vertex> left;
  };
  [[nodiscard]] bool reached() const { return goal_ > 0 && mesh_.count(2) <= goal_; }
  [[nodiscard]] Vertex next_left();
  bool begin_round();
  [[nodiscard]] std::uint32_t lowest_bucket();
  void share_out(std::uint64_t faces, std::uint64_t waiting);

  const Mesh& mesh_;
  CollapseQueue& queue_;
  const Partition& partition_;
  std::uint32_t goal_ = 0;
  std::uint32_t bucket_ = 0;  ///< the last one of the round
  std::vector<Part> parts_;   ///< none where there is one part only
  std::size_t turn_ = 0;      ///< the part whose turn it is; past the last one: the seam's
  std::vector<Vertex> left_;  ///< by all parts, in the order of ids
  std::size_t next_left_ = 0;
};

}  // namespace aomd
