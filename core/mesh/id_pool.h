#pragma once
// The id stack (paper, section 2.1.1): ids of deleted entities are given to the next ones, last
// freed first.

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#pragma GCC visibility push(default)

namespace aomd {

/// Gives out the ids of one level and knows which are alive. Every operation O(1).
class IdPool {
 public:
  /// A new id and whether it is fresh (the maximum plus one) rather than taken from the stack.
  struct Created {
    std::uint32_t id;
    bool fresh;
  };

  [[nodiscard]] bool alive(std::uint32_t id) const {
    return id < capacity_ && ((bits_[id >> 6] >> (id & 63u)) & 1u);
  }
  /// The first id at or after `id` that is alive, or capacity(). Skips 64 dead ones at a time.
  [[nodiscard]] std::uint32_t next_alive(std::uint32_t id) const {
    while (id < capacity_) {
      const std::uint64_t rest = bits_[id >> 6] >> (id & 63u);
      if (rest) return id + static_cast<std::uint32_t>(std::countr_zero(rest));
      id = (id | 63u) + 1;
    }
    return capacity_;
  }
  /// One past the largest id ever alive: the size of arrays indexed by id.
  [[nodiscard]] std::uint32_t capacity() const { return capacity_; }
  /// How many ids are alive.
  [[nodiscard]] std::uint32_t size() const {
    return capacity_ - static_cast<std::uint32_t>(free_.size());
  }
  /// The stack of freed ids, the next one to be given out last.
  [[nodiscard]] const std::vector<std::uint32_t>& free_ids() const { return free_; }
  [[nodiscard]] std::size_t bytes() const { return bits_.capacity() * 8 + free_.capacity() * 4; }

  Created create();
  void destroy(std::uint32_t id);
  /// `count` fresh ids in one go, whatever the stack holds. Returns the first.
  std::uint32_t create_many(std::uint32_t count);

  /// Exact inverses, for undo in reverse order: afterwards the pool equals the one before.
  void undo_create(std::uint32_t id, bool fresh);
  void undo_destroy(std::uint32_t id);

  friend bool operator==(const IdPool&, const IdPool&) = default;

 private:
  void mark(std::uint32_t id) { bits_[id >> 6] |= std::uint64_t{1} << (id & 63u); }
  void clear(std::uint32_t id) { bits_[id >> 6] &= ~(std::uint64_t{1} << (id & 63u)); }

  std::vector<std::uint64_t> bits_;
  std::vector<std::uint32_t> free_;
  std::uint32_t capacity_ = 0;
};

/// Calls visit(id) for the ids in [begin, end) that are alive, in ascending order; they must stay
/// as they are meanwhile.
template <typename Visit>
void each_alive(const IdPool& ids, std::size_t begin, std::size_t end, Visit&& visit) {
  const auto last = static_cast<std::uint32_t>(std::min<std::size_t>(end, ids.capacity()));
  if (ids.free_ids().empty()) {
    for (auto id = static_cast<std::uint32_t>(begin); id < last; ++id) visit(id);
    return;
  }
  for (std::uint32_t id = ids.next_alive(static_cast<std::uint32_t>(begin)); id < last;
       id = ids.next_alive(id + 1))
    visit(id);
}

}  // namespace aomd

#pragma GCC visibility pop
