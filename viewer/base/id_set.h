#pragma once
// Ids, each once, that come out in ascending order: a bit for each.

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

namespace aomd::scene {

/// Cheaper than sorting from a few hundred ids on; kept by its user, so that adding does not
/// allocate.
class IdSet {
 public:
  /// O(1).
  void add(std::uint32_t id) {
    const std::size_t word = id / 64;
    if (word >= bits_.size()) bits_.resize(word + 1, 0);
    bits_[word] |= std::uint64_t{1} << (id % 64);
    first_ = std::min(first_, word);
    end_ = std::max(end_, word + 1);
  }
  /// The ids as handles; the set is empty afterwards. O(ids + (largest - smallest) / 64).
  template <typename H>
  [[nodiscard]] std::vector<H> take() {
    std::vector<H> handles;
    for (std::size_t word = first_; word < end_; ++word) {
      for (std::uint64_t rest = bits_[word]; rest != 0; rest &= rest - 1)
        handles.emplace_back(static_cast<std::uint32_t>(64 * word) +
                             static_cast<std::uint32_t>(std::countr_zero(rest)));
      bits_[word] = 0;
    }
    first_ = no_word;
    end_ = 0;
    return handles;
  }

 private:
  static constexpr std::size_t no_word = ~std::size_t{0};
  std::vector<std::uint64_t> bits_;
  std::size_t first_ = no_word;  ///< words [first_, end_) may hold some
  std::size_t end_ = 0;
};

}  // namespace aomd::scene
