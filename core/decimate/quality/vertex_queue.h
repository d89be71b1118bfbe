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
        return v;
      }
    } while (begin_batch());
    return {};
  }
  /// True when a vertex at this cost would belong to the bucket that is worked off, or one below.
  [[nodiscard]] bool is_next(float cost) const { return bucket_of(cost) <= present_; }

 private:
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
};

}  // namespace aomd
