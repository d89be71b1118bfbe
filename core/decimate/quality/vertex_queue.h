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
/// Where there are several parts, each has a queue of its own vertices, and a thread of its own may
/// use it.
class VertexQueue {
 public:
  static constexpr std::uint32_t no_bucket = 1u << 9;  ///< above all of them

  void reset(std::size_t vertices, std::size_t parts = 1) {
    parts_.assign(parts, {});
    bucket_.assign(vertices, absent);
  }
  [[nodiscard]] bool holds(Vertex v) const { return bucket_[v] != absent; }
  /// Puts a vertex at a cost, or moves it there; always in the same part.
  void put(Vertex v, float cost, std::size_t part = 0) {
    const std::uint16_t b = bucket_of(cost);
    if (bucket_[v] == b) return;
    remove(v, part);
    Part& p = parts_[part];
    bucket_[v] = b;
    p.buckets[b].listed.push_back(v.index);
    ++p.buckets[b].waiting;
    p.lowest = std::min(p.lowest, std::uint32_t{b});
  }
  void remove(Vertex v, std::size_t part = 0) {
    const std::uint16_t b = std::exchange(bucket_[v], absent);
    if (b != absent) --parts_[part].buckets[b].waiting;
  }
  /// The next vertex, which leaves; an invalid one when there is none, or none up to a bucket.
  [[nodiscard]] Vertex pop(std::size_t part = 0, std::uint32_t last = no_bucket) {
    Part& p = parts_[part];
    do {
      while (p.turn < p.batch.size()) {
        const Vertex v(p.batch[p.turn++]);
        if (bucket_[v] != p.present) continue;  // it has left, or waits elsewhere
        remove(v, part);
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
  /// How many vertices of a part wait in these buckets, the last one included.
  [[nodiscard]] std::uint64_t waiting(std::size_t part, std::uint32_t first,
                                      std::uint32_t last) const {
    std::uint64_t sum = 0;
    for (std::uint32_t b = first; b <= last; ++b) sum += parts_[part].buckets[b].waiting;
    return sum;
  }
  /// What is left of the bucket that a part works off waits as if it had just arrived.
  void leave_bucket(std::size_t part) {
    Part& p = parts_[part];
    std::vector<std::uint32_t>& listed = p.buckets[p.present].listed;
    listed.insert(listed.end(), p.batch.begin() + p.turn, p.batch.end());
    p.batch.clear(), p.turn = 0;
  }

 private:
  struct Bucket {
    std::vector<std::uint32_t> listed;  ///< who has left since among them, and who came back twice
    std::uint32_t waiting = 0;
  };
  struct alignas(64) Part {
    std::vector<Bucket> buckets = std::vector<Bucket>(no_bucket);
    std::uint32_t lowest = no_bucket;
    std::vector<std::uint32_t> batch;  ///< the bucket that is worked off
    std::uint32_t present = 0, turn = 0;
  };
  // The exponent and the first bit of the mantissa: ordered as the numbers are.
  static std::uint16_t bucket_of(float cost) {
    return static_cast<std::uint16_t>(std::bit_cast<std::uint32_t>(cost) >> 22);
  }
  static constexpr std::uint16_t absent = no_bucket;

  static std::uint32_t lowest_of(Part& p) {
    for (; p.lowest < no_bucket && p.buckets[p.lowest].waiting == 0; ++p.lowest)
      p.buckets[p.lowest].listed.clear();
    return p.lowest;
  }
  bool begin_batch(Part& p, std::uint32_t last) {
    const std::uint32_t lowest = lowest_of(p);
    if (lowest == no_bucket || lowest > last) return false;
    p.batch = std::exchange(p.buckets[lowest].listed, {});
    std::erase_if(p.batch, [&](std::uint32_t v) { return bucket_[Vertex(v)] != lowest; });
    std::sort(p.batch.begin(), p.batch.end());
    p.batch.erase(std::unique(p.batch.begin(), p.batch.end()), p.batch.end());
    p.present = lowest;
    p.turn = 0;
    return true;
  }

  std::vector<Part> parts_ = std::vector<Part>(1);
  Column<Vertex, std::uint16_t> bucket_;  ///< where each vertex stands
};

}  // namespace aomd
