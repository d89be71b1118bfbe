#pragma once
// What there is to show of hash sets and id stacks (paper, section 2.1.1).

#include <array>
#include <cstdint>
#include <vector>

#include "core/mesh/mesh.h"

namespace aomd::scene {

/// The hash set of one level. Without one all is zero.
struct HashFacts {
  /// One bar for each number of entities in a bucket from 0 on; the last one counts the crowded
  /// ones.
  static constexpr std::size_t bars = EntityHash::crowded_length + 1;

  bool built = false;
  std::uint64_t entities = 0;
  std::size_t bytes = 0;
  EntityHash::Statistics statistics;
  std::array<std::uint32_t, bars> buckets{};
  std::vector<EntityHash::Rehash> rehashes;

  /// Of the buckets that are used, those with 10 or more entities, 0..1: beyond 0.1 the set grows.
  [[nodiscard]] double crowded_share() const {
    return statistics.used == 0 ? 0 : static_cast<double>(statistics.crowded) / statistics.used;
  }
};
/// level 1 to 3. O(buckets).
[[nodiscard]] HashFacts hash_facts(const Mesh& mesh, int level);

/// The ids of one level.
struct IdFacts {
  static constexpr std::size_t most_shown = 8;

  std::uint32_t alive = 0;
  std::uint32_t free = 0;          ///< on the stack
  std::uint32_t capacity = 0;      ///< one past the largest id ever alive
  std::uint32_t next = 0;          ///< what the next entity gets
  std::vector<std::uint32_t> top;  ///< of the stack, the next one to be given out first
};
/// level 0 to 3. O(1).
[[nodiscard]] IdFacts id_facts(const Mesh& mesh, int level);

}  // namespace aomd::scene
