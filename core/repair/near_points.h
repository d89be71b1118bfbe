#pragma once
// Points in cells as wide as a distance: what lies within it is found in O(1).

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include <glm/vec3.hpp>

namespace aomd::repair_detail {

/// Numbers of points, by their cells. Cells are told apart by a hash, so that numbers of points
/// further away may be met too.
class NearPoints {
 public:
  /// A cell takes no more than the first `most` points.
  explicit NearPoints(double distance, std::size_t most = SIZE_MAX)
      : width_(distance), most_(most) {}

  void add(std::uint32_t number, const glm::dvec3& p) {
    auto& points = cells_[key(cell(p))];
    if (points.size() < most_)
      points.push_back(number);
    else
      ++dropped_;
  }
  /// Points that their cells did not take.
  [[nodiscard]] std::size_t dropped() const { return dropped_; }

  /// Calls visit(number) for all points within the distance of p, and for others; for one of them
  /// perhaps more than once.
  template <typename Visit>
  void each_near(const glm::dvec3& p, Visit&& visit) const {
    const glm::dvec3 middle = cell(p);
    for (int i = 0; i < 27; ++i) {
      const glm::dvec3 step(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
      const auto it = cells_.find(key(middle + step));
      if (it == cells_.end()) continue;
      for (const std::uint32_t number : it->second) visit(number);
    }
  }

 private:
  [[nodiscard]] glm::dvec3 cell(const glm::dvec3& p) const {
    return {std::floor(p.x / width_), std::floor(p.y / width_), std::floor(p.z / width_)};
  }
  [[nodiscard]] static std::uint64_t key(const glm::dvec3& cell) {
    std::uint64_t h = 0;
    for (int axis = 0; axis < 3; ++axis) {
      h ^= std::bit_cast<std::uint64_t>(cell[axis] + 0.0);  // + 0 makes -0 and 0 one
      h *= 0x9e3779b97f4a7c15u;
      h ^= h >> 32;
    }
    return h;
  }

  double width_;
  std::size_t most_, dropped_ = 0;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells_;
};

}  // namespace aomd::repair_detail
