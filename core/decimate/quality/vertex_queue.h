#pragma once
// Vertices in the order of a cost, roughly: buckets of half an octave, each worked off in the order
// of ids.

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

#include "core/mesh/column.h"
#include "core/mesh/handle.h"

namespace aomd {

/// A queue in which every vertex stands at most once, at a cost that is not negative. The lowest
/// bucket leaves in the order of ids, because vertices that follow each other in a file tend to lie
/// next to each other, in memory too; what arrives in that bucket or below it meanwhile waits until
/// it is done. put and remove are O(1), a pop O(log n) amortised.
class VertexQueue {
 public:
  void reset(std::size_t vertices) {
    first_.assign(bucket_count, no_index);
    links_.assign(vertices, {});
    lowest_ = bucket_count;
    batch_.clear();
    present_ = turn_ = 0;
  }
  [[nodiscard]] bool holds(Vertex v) const { return links_[v].bucket != absent; }
  /// Puts a vertex at a cost, or moves it there.
  void put(Vertex v, float cost) {
    remove(v);
    const std::uint32_t b = bucket_of(cost);
    links_[v] = {first_[b], no_index, b};
    if (first_[b] != no_index) links_[Vertex(first_[b])].previous = v.index;
    first_[b] = v.index;
    if (b < lowest_) lowest_ = b;
  }
  void remove(Vertex v) {
    Link& l = links_[v];
    if (l.bucket == absent) return;
    if (l.previous != no_index)
      links_[Vertex(l.previous)].next = l.next;
    else
      first_[l.bucket] = l.next;
    if (l.next != no_index) links_[Vertex(l.next)].previous = l.previous;
    l.bucket = absent;
  }
  /// The next vertex, which leaves; an invalid one when there is none.
  [[nodiscard]] Vertex pop() {
    do {
      while (turn_ < batch_.size()) {
        const Vertex v(batch_[turn_++]);
        if (links_[v].bucket != present_) continue;  // it has left, or waits elsewhere
        remove(v);
        return v;
      }
    } while (begin_batch());
    return {};
  }
  /// True when a vertex at this cost would belong to the bucket that is worked off, or one below.
  [[nodiscard]] bool is_next(float cost) const { return bucket_of(cost) <= present_; }

 private:
  struct Link {
    std::uint32_t next = no_index, previous = no_index, bucket = absent;
  };
  // The exponent and the first bit of the mantissa: ordered as the numbers are.
  static std::uint32_t bucket_of(float cost) { return std::bit_cast<std::uint32_t>(cost) >> 22; }
  static constexpr std::uint32_t bucket_count = 1u << 9, absent = no_index;

  bool begin_batch() {
    while (lowest_ < bucket_count && first_[lowest_] == no_index) ++lowest_;
    if (lowest_ == bucket_count) return false;
    batch_.clear();
    for (std::uint32_t i = first_[lowest_]; i != no_index; i = links_[Vertex(i)].next)
      batch_.push_back(i);
    std::sort(batch_.begin(), batch_.end());
    present_ = lowest_;
    turn_ = 0;
    return true;
  }

  std::vector<std::uint32_t> first_;  ///< by bucket
  Column<Vertex, Link> links_;
  std::uint32_t lowest_ = bucket_count;
  std::vector<std::uint32_t> batch_;  ///< the bucket that is worked off
  std::uint32_t present_ = 0, turn_ = 0;
};

}  // namespace aomd
