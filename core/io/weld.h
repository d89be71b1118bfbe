#pragma once
// Gives equal points the same number.

#include <bit>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace aomd::io::detail {

/// Collects points; points whose coordinates compare equal (so -0 and 0) become one. O(1) a point.
class Welder {
 public:
  /// The number of this point, in order of first appearance.
  std::uint32_t add(const glm::dvec3& p) {
    if (2 * (points_.size() + 1) > slots_.size()) grow();
    std::uint32_t& slot = find(p);
    if (slot == empty) {
      slot = static_cast<std::uint32_t>(points_.size());
      points_.push_back(p);
    }
    return slot;
  }
  [[nodiscard]] std::size_t size() const { return points_.size(); }
  [[nodiscard]] std::vector<glm::dvec3> take() { return std::move(points_); }

 private:
  static constexpr std::uint32_t empty = 0xffffffffu;

  static std::uint64_t hash(const glm::dvec3& p) {
    std::uint64_t h = 0;
    for (int axis = 0; axis < 3; ++axis) {
      h ^= std::bit_cast<std::uint64_t>(p[axis] + 0.0);  // + 0 makes -0 and 0 one
      h *= 0x9e3779b97f4a7c15u;
      h ^= h >> 32;
    }
    return h;
  }

  std::uint32_t& find(const glm::dvec3& p) {
    const std::size_t mask = slots_.size() - 1;
    for (std::size_t i = hash(p) & mask;; i = (i + 1) & mask) {
      if (slots_[i] == empty || points_[slots_[i]] == p) return slots_[i];
    }
  }

  void grow() {
    slots_.assign(slots_.empty() ? 64 : 2 * slots_.size(), empty);
    for (std::uint32_t i = 0; i < points_.size(); ++i) find(points_[i]) = i;
  }

  std::vector<glm::dvec3> points_;
  std::vector<std::uint32_t> slots_;
};

}  // namespace aomd::io::detail
