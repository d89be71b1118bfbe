#pragma once
// Vertices in the order of a cost, nearly: buckets of about 4 percent.

#include <bit>
#include <cstdint>
#include <vector>

#include "core/mesh/column.h"
#include "core/mesh/handle.h"

namespace aomd {

/// A queue in which every vertex stands at most once. Costs are not negative; each bucket covers a sixteenth
/// of an octave, so that equals leave in the reverse order of their arrival. Everything is O(1), a pop
/// amortised.
class VertexQueue {
 public:
  void reset(std::size_t vertices) {
    first_.assign(bucket_count, no_index);
    links_.assign(vertices, {});
    lowest_ = bucket_count;
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
  /// The vertex of the lowest bucket that arrived last, which leaves; an invalid one when there is none.
  [[nodiscard]] Vertex pop() {
    while (lowest_ < bucket_count && first_[lowest_] == no_index) ++lowest_;
    if (lowest_ == bucket_count) return {};
    const Vertex v(first_[lowest_]);
    remove(v);
    return v;
  }
  /// True when nothing that stands in the queue is in a lower bucket than `cost`.
  [[nodiscard]] bool is_next(float cost) {
    while (lowest_ < bucket_count && first_[lowest_] == no_index) ++lowest_;
    return bucket_of(cost) <= lowest_;
  }

 private:
  struct Link {
    std::uint32_t next = no_index, previous = no_index, bucket = absent;
  };
  // The exponent and the first four bits of the mantissa: ordered as the numbers are.
  static std::uint32_t bucket_of(float cost) { return std::bit_cast<std::uint32_t>(cost) >> 19; }
  static constexpr std::uint32_t bucket_count = 1u << 12, absent = no_index;

  std::vector<std::uint32_t> first_;  ///< by bucket
  Column<Vertex, Link> links_;
  std::uint32_t lowest_ = 0;
};

}  // namespace aomd
