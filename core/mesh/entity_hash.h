#pragma once
// Finds an entity from its vertices where no stored adjacency can (paper, section 2.1.1).

#include <cstdint>
#include <span>
#include <vector>

#include "core/mesh/handle.h"

#pragma GCC visibility push(default)

namespace aomd {

/// A chained hash set of the entities of one level. The key is the sum of randomised vertex ids,
/// the same on every platform; different entities may share a key, so the caller compares vertices.
/// The set watches itself: when more than 10 % of its used buckets hold 10 or more entities it
/// grows tenfold, up to a limit.
class EntityHash {
 public:
  [[nodiscard]] static std::uint64_t mix(std::uint32_t vertex);
  [[nodiscard]] static std::uint64_t key(std::span<const std::uint32_t> vertices);

  struct Statistics {
    std::uint32_t buckets = 0, used = 0, crowded = 0, worst = 0, rehashes = 0;
  };
  /// From how many entities in a bucket on it is crowded.
  static constexpr std::uint16_t crowded_length = 10;
  /// A growth: with so many entities in the set, so many buckets became so many.
  struct Rehash {
    std::uint32_t entities = 0, before = 0, after = 0;
    friend bool operator==(const Rehash&, const Rehash&) = default;
  };

  [[nodiscard]] bool built() const { return !first_.empty(); }
  [[nodiscard]] Statistics statistics() const;
  /// Since it was built, the first one first.
  [[nodiscard]] const std::vector<Rehash>& rehashes() const { return rehashes_; }
  /// How many buckets hold 0, 1, 2, ... entities, up to the worst; lengths past 65,535 count as
  /// that. O(buckets).
  [[nodiscard]] std::vector<std::uint32_t> lengths() const;
  [[nodiscard]] std::size_t bytes() const {
    return (first_.capacity() + next_.capacity()) * 4 + keys_.capacity() * 8 +
           length_.capacity() * 2;
  }

  [[nodiscard]] std::uint64_t key_of(std::uint32_t entity) const { return keys_[entity]; }

  /// An empty set with room for about `expected` entities.
  void build(std::uint32_t expected);
  void insert(std::uint64_t key, std::uint32_t entity);
  void erase(std::uint32_t entity);
  void release() { *this = EntityHash(); }

  /// The smallest entity with this key for which `same(entity)` holds, or no_index. Expected O(1).
  template <typename Same>
  [[nodiscard]] std::uint32_t find(std::uint64_t key, Same&& same) const {
    std::uint32_t found = no_index;
    for (std::uint32_t e = first_[bucket(key)]; e != no_index; e = next_[e])
      if (keys_[e] == key && e < found && same(e)) found = e;
    return found;
  }

  /// Calls visit(entity) for everything in the set.
  template <typename Visit>
  void for_each(Visit&& visit) const {
    for (const std::uint32_t head : first_)
      for (std::uint32_t e = head; e != no_index; e = next_[e]) visit(e);
  }

 private:
  [[nodiscard]] std::size_t bucket(std::uint64_t key) const { return key % first_.size(); }
  void link(std::uint32_t entity);
  void grow_when_crowded();

  std::vector<std::uint32_t> first_;   ///< by bucket
  std::vector<std::uint16_t> length_;  ///< by bucket, saturated
  std::vector<std::uint32_t> next_;    ///< by entity
  std::vector<std::uint64_t> keys_;    ///< by entity
  std::uint32_t used_ = 0, crowded_ = 0;
  std::vector<Rehash> rehashes_;
};

}  // namespace aomd

#pragma GCC visibility pop
