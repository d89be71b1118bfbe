#pragma once
// Which of many numbers belong together, while pairs of them are united.

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace aomd {

/// Disjoint sets of the numbers below n: of vertices, corners or faces. Each starts as a set of its
/// own. find and unite are O(log n) amortised.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t n) : parent_(n) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }
  /// The number that stands for the set: the same for all that belong together.
  [[nodiscard]] std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  /// The smaller of the two numbers that stand for the sets stays.
  void unite(std::uint32_t a, std::uint32_t b) {
    a = find(a), b = find(b);
    if (b < a) std::swap(a, b);
    parent_[b] = a;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace aomd
