#pragma once
// Points in cells twice as wide as a distance: what lies within it is found in O(1).

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "core/mesh/handle.h"

namespace aomd::repair_detail {

/// Numbers of points, by their cells. Cells are told apart by a hash, so that numbers of points
/// further away may be met too.
class NearPoints {
 public:
  /// A cell takes no more than the first `most` points.
  explicit NearPoints(double distance, std::size_t most = SIZE_MAX)
      : width_(2.001 * distance), most_(most), cells_(1024) {}

  void add(std::uint32_t number, const glm::dvec3& p) {
    if (2 * (used_ + 1) > cells_.size()) grow();
    Cell& cell = cells_[place(key(floor(p / width_)))];
    if (cell.count >= most_) return void(++dropped_);
    used_ += cell.count == 0;
    cell.key = key(floor(p / width_));
    points_.push_back({number, cell.last});
    cell.last = static_cast<std::uint32_t>(points_.size() - 1);
    ++cell.count;
  }
  /// Points that their cells did not take.
  [[nodiscard]] std::size_t dropped() const { return dropped_; }

  /// Calls visit(number) for all points within the distance of p, and for others; for one of them
  /// perhaps more than once.
  template <typename Visit>
  void each_near(const glm::dvec3& p, Visit&& visit) const {
    const glm::dvec3 at = p / width_, own = floor(at);
    for (int corner = 0; corner < 8; ++corner) {
      glm::dvec3 cell = own;
      for (int axis = 0; axis < 3; ++axis)
        if ((corner >> axis & 1) != 0) cell[axis] += at[axis] - own[axis] < 0.5 ? -1 : 1;
      for (std::uint32_t i = cells_[place(key(cell))].last; i != no_index; i = points_[i].before)
        visit(points_[i].number);
    }
  }

 private:
  struct Cell {
    std::uint64_t key = 0;
    std::uint32_t last = no_index, count = 0;
  };
  struct Point {
    std::uint32_t number, before;  ///< in the same cell
  };

  [[nodiscard]] static glm::dvec3 floor(const glm::dvec3& p) {
    return {std::floor(p.x), std::floor(p.y), std::floor(p.z)};
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
  // Where the cell is, or a free place.
  [[nodiscard]] std::size_t place(std::uint64_t key) const {
    const std::size_t mask = cells_.size() - 1;
    std::size_t i = key & mask;
    while (cells_[i].count > 0 && cells_[i].key != key) i = (i + 1) & mask;
    return i;
  }
  void grow() {
    const std::vector<Cell> old = std::exchange(cells_, std::vector<Cell>(2 * cells_.size()));
    for (const Cell& cell : old)
      if (cell.count > 0) cells_[place(cell.key)] = cell;
  }

  double width_;
  std::size_t most_, used_ = 0, dropped_ = 0;
  std::vector<Cell> cells_;
  std::vector<Point> points_;
};

}  // namespace aomd::repair_detail
