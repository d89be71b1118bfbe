#pragma once
// Vertices in the order of a cost, roughly: buckets of half an octave, each worked off in the order
// of ids.

#include <algorithm>
#include <bit>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/mesh/column.h"
#include "core/mesh/handle.h"

namespace aomd {

/// A queue in which every vertex stands at most once, at a cost that is not negative. The lowest
/// bucket leaves in the order of ids, because vertices that follow each other in a file tend to lie
/// next to each other, in memory too; what arrives in that bucket or below it meanwhile waits until
<<<<<<< HEAD
/// it is done. put and remove are O(1), a pop O(log n) amortised. A bucket lists who was put there,
/// and who has left since is passed over when its turn comes: leaving touches no other vertex.
class VertexQueue {
 public:
  void reset(std::size_t vertices) {
    buckets_.assign(bucket_count, {});
    bucket_.assign(vertices, absent);
    lowest_ = bucket_count;
    batch_.clear();
    present_ = turn_ = 0;
  }
  [[nodiscard]] bool holds(Vertex v) const { return bucket_[v] != absent; }
  /// Puts a vertex at a cost, or moves it there.
  void put(Vertex v, float cost) {
    const std::uint16_t b = bucket_of(cost);
    if (bucket_[v] == b) return;
    bucket_[v] = b;
    buckets_[b].push_back(v.index);
    if (b < lowest_) lowest_ = b;
  }
  void remove(Vertex v) { bucket_[v] = absent; }
  /// The next vertex, which leaves; an invalid one when there is none.
  [[nodiscard]] Vertex pop() {
    do {
      while (turn_ < batch_.size()) {
        const Vertex v(batch_[turn_++]);
        if (bucket_[v] != present_) continue;  // it has left, or waits elsewhere
        remove(v);
=======
/// it is done. put and remove are O(1), a pop O(log n) amortised. Where there are several parts,
/// each has a queue of its own vertices, and a thread of its own may use it.
class VertexQueue {
 public:
  static constexpr std::uint32_t no_bucket = 1u << 9;  ///< above all of them

  void reset(std::size_t vertices, std::size_t parts = 1) {
    parts_.assign(parts, {});
    links_.assign(vertices, {});
  }
  [[nodiscard]] bool holds(Vertex v) const { return links_[v].bucket != absent; }
  /// Puts a vertex at a cost, or moves it there; always in the same part.
  void put(Vertex v, float cost, std::size_t part = 0) {
    remove(v, part);
    Part& p = parts_[part];
    const std::uint32_t b = bucket_of(cost);
    Bucket& bucket = p.buckets[b];
    links_[v] = {bucket.first, no_index, b};
    if (bucket.first != no_index) links_[Vertex(bucket.first)].previous = v.index;
    bucket.first = v.index;
    ++bucket.count;
    if (b < p.lowest) p.lowest = b;
  }
  void remove(Vertex v, std::size_t part = 0) {
    Link& l = links_[v];
    if (l.bucket == absent) return;
    Bucket& bucket = parts_[part].buckets[l.bucket];
    if (l.previous != no_index)
      links_[Vertex(l.previous)].next = l.next;
    else
      bucket.first = l.next;
    --bucket.count;
    if (l.next != no_index) links_[Vertex(l.next)].previous = l.previous;
    l.bucket = absent;
  }
  /// The next vertex, which leaves; an invalid one when there is none, or none up to a bucket.
  [[nodiscard]] Vertex pop(std::size_t part = 0, std::uint32_t last = no_bucket) {
    Part& p = parts_[part];
    do {
      while (p.turn < p.batch.size()) {
        const Vertex v(p.batch[p.turn++]);
        if (links_[v].bucket != p.present) continue;  // it has left, or waits elsewhere
        remove(v, part);
>>>>>>> w/parts
        return v;
      }
    } while (begin_batch(p, last));
    return {};
  }
  /// True when a vertex at this cost would belong to the bucket that is worked off, or one below.
  [[nodiscard]] bool is_next(float cost, std::size_t part = 0) const {
    return bucket_of(cost) <= parts_[part].present;
  }
  /// The lowest bucket in which something waits; no_bucket where nothing does.
  [[nodiscard]] std::uint32_t lowest(std::size_t part = 0) { return lowest_of(parts_[part]); }
  /// How many vertices of a part wait in a bucket.
  [[nodiscard]] std::uint32_t waiting(std::size_t part, std::uint32_t bucket) const {
    return parts_[part].buckets[bucket].count;
  }
  /// What is left of the bucket that a part works off waits as if it had just arrived.
  void leave_bucket(std::size_t part) { parts_[part].batch.clear(), parts_[part].turn = 0; }

 private:
<<<<<<< HEAD
  // The exponent and the first bit of the mantissa: ordered as the numbers are.
  static std::uint16_t bucket_of(float cost) {
    return static_cast<std::uint16_t>(std::bit_cast<std::uint32_t>(cost) >> 22);
  }
  static constexpr std::uint16_t bucket_count = 1u << 9, absent = bucket_count;

  // Who has left since is listed still, and who came back twice.
  bool begin_batch() {
    turn_ = 0;
    for (batch_.clear(); lowest_ < bucket_count; ++lowest_) {
      batch_ = std::exchange(buckets_[lowest_], {});
      std::erase_if(batch_, [this](std::uint32_t v) { return bucket_[Vertex(v)] != lowest_; });
      std::sort(batch_.begin(), batch_.end());
      batch_.erase(std::unique(batch_.begin(), batch_.end()), batch_.end());
      if (batch_.empty()) continue;
      present_ = lowest_;
      return true;
    }
    return false;
  }

  std::vector<std::vector<std::uint32_t>> buckets_;
  Column<Vertex, std::uint16_t> bucket_;  ///< where each vertex stands
  std::uint16_t lowest_ = bucket_count;
  std::vector<std::uint32_t> batch_;  ///< the bucket that is worked off
  std::uint16_t present_ = 0;
  std::size_t turn_ = 0;
=======
  struct Link {
    std::uint32_t next = no_index, previous = no_index, bucket = absent;
  };
  struct Bucket {
    std::uint32_t first = no_index, count = 0;
  };
  struct alignas(64) Part {
    std::vector<Bucket> buckets = std::vector<Bucket>(no_bucket);
    std::uint32_t lowest = no_bucket;
    std::vector<std::uint32_t> batch;  ///< the bucket that is worked off
    std::uint32_t present = 0, turn = 0;
  };
  // The exponent and the first bit of the mantissa: ordered as the numbers are.
  static std::uint32_t bucket_of(float cost) { return std::bit_cast<std::uint32_t>(cost) >> 22; }
  static constexpr std::uint32_t absent = no_index;

  static std::uint32_t lowest_of(Part& p) {
    while (p.lowest < no_bucket && p.buckets[p.lowest].first == no_index) ++p.lowest;
    return p.lowest;
  }
  bool begin_batch(Part& p, std::uint32_t last) {
    const std::uint32_t lowest = lowest_of(p);
    if (lowest == no_bucket || lowest > last) return false;
    p.batch.clear();
    for (std::uint32_t i = p.buckets[lowest].first; i != no_index; i = links_[Vertex(i)].next)
      p.batch.push_back(i);
    std::sort(p.batch.begin(), p.batch.end());
    p.present = lowest;
    p.turn = 0;
    return true;
  }

  std::vector<Part> parts_ = std::vector<Part>(1);
  Column<Vertex, Link> links_;
>>>>>>> w/parts
};

}  // namespace aomd
