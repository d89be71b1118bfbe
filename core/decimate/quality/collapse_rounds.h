#pragma once
// In which order the parts of a mesh take their turns, so that it becomes coarser everywhere as by
// one part.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/mesh/mesh.h"

namespace aomd {

/// What is counted down to a target, and how.
struct RoundRules {
  int dimension = 2;                  ///< of the entities that a target counts
  std::uint64_t most_each = 2;        ///< that go with a collapse
  std::uint32_t buckets_far_off = 1;  ///< of a round while far more than the target is left
};

/// All parts work off the same bucket of costs, each its own vertices in the order of ids; what is
/// not for a part alone waits until all have done so, and then has its turn in the order of ids.
/// Then comes the next bucket. Far above the target it may be many buckets at once, so that what a
/// part works on stays in the caches; where the target is near, each part may take away its share
/// of the faces or regions that are left to go. One part is the plain queue. What the parts do
/// within a round does not depend on each other: they may do it one after the other or at once.
/// The queue, a VertexQueue or a CollapseQueue, has one queue for each part.
template <typename Queue>
class CollapseRounds {
 public:
  CollapseRounds(const Mesh& mesh, Queue& queue, const RoundRules& rules)
      : mesh_(mesh), queue_(queue), rules_(rules) {}

  /// The queue was filled anew, for so many parts, to be worked off until so many faces or regions
  /// are left (0: to its end).
  void begin(std::uint32_t goal, std::size_t parts);
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

  /// What a part has left to who comes after; and how many faces or regions it has taken away.
  void leave(std::size_t part, Vertex v) { parts_[part].left.push_back(v); }
  void took(std::size_t part, std::size_t gone) { parts_[part].taken += gone; }

 private:
  /// A part within a round.
  struct alignas(64) Part {
    std::uint64_t share = 0;  ///< of the faces or regions that may go
    std::uint64_t taken = 0;  ///< that have gone
    std::uint64_t seen = 0;   ///< vertices that have had their turn
    std::vector<Vertex> left;
  };
  [[nodiscard]] bool reached() const { return goal_ > 0 && mesh_.count(rules_.dimension) <= goal_; }
  [[nodiscard]] Vertex next_left();
  bool begin_round();
  [[nodiscard]] std::uint32_t lowest_bucket();
  [[nodiscard]] std::uint64_t may_go();
  void share_out(std::uint64_t most, std::uint64_t waiting);

  const Mesh& mesh_;
  Queue& queue_;
  RoundRules rules_;
  std::uint32_t goal_ = 0;
  std::uint32_t bucket_ = 0;  ///< the last one of the round
  std::vector<Part> parts_;   ///< none where there is one part only
  std::size_t turn_ = 0;      ///< the part whose turn it is; past the last one: what was left
  std::vector<Vertex> left_;  ///< by all parts, in the order of ids
  std::size_t next_left_ = 0;
};

}  // namespace aomd
