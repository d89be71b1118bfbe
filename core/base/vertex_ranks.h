#pragma once
// Numbers for some of very many vertices.

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace aomd {

/// A set of vertices that numbers its members in ascending order: one and a half bits a vertex.
class VertexRanks {
 public:
  explicit VertexRanks(std::size_t vertices) : words_((vertices + bits - 1) / bits, 0) {}

  void add(std::uint32_t v) { words_[v / bits] |= one(v); }
  /// All are there: they can be asked for now. O(vertices / 64).
  void finish() {
    before_.clear();
    count_ = 0;
    for (const std::uint64_t word : words_) {
      before_.push_back(count_);
      count_ += static_cast<std::uint32_t>(std::popcount(word));
    }
  }

  [[nodiscard]] std::uint32_t count() const { return count_; }
  [[nodiscard]] bool has(std::uint32_t v) const { return (words_[v / bits] & one(v)) != 0; }
  /// How many members come before one.
  [[nodiscard]] std::uint32_t rank(std::uint32_t v) const {
    const std::uint64_t below = words_[v / bits] & (one(v) - 1);
    return before_[v / bits] + static_cast<std::uint32_t>(std::popcount(below));
  }

 private:
  static constexpr std::uint32_t bits = 64;
  [[nodiscard]] static std::uint64_t one(std::uint32_t v) { return std::uint64_t{1} << v % bits; }

  std::vector<std::uint64_t> words_;
  std::vector<std::uint32_t> before_;
  std::uint32_t count_ = 0;
};

}  // namespace aomd
