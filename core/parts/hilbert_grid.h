#pragma once
// A cube of cells around a surface, which a curve goes through.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "core/base/box.h"
#include "core/parts/hilbert.h"

namespace aomd {

class HilbertGrid {
 public:
  /// 2^bits cells along each side. The planes that halve the cube of one cut, and the halves again,
  /// are not those of the next.
  HilbertGrid(const Box& box, int bits, int cut = 0) : bits_(bits) {
    if (box.empty()) return;
    const glm::dvec3 size = box.high - box.low;
    const double side = std::max({size.x, size.y, size.z}) * (1 + 0.3 * cut);
    low_ = box.low - glm::dvec3(0.17 * cut * side);
    if (side > 0) cells_per_unit_ = (1u << bits) / side;
  }

  [[nodiscard]] std::size_t cells() const { return std::size_t{1} << 3 * bits_; }
  /// Of the cell of a point along the curve, below cells().
  [[nodiscard]] std::uint32_t place(const glm::dvec3& p) const {
    std::array<std::uint32_t, 3> cell{};
    for (int k = 0; k < 3; ++k)
      cell[static_cast<std::size_t>(k)] = static_cast<std::uint32_t>(
          std::clamp((p[k] - low_[k]) * cells_per_unit_, 0.0, double((1u << bits_) - 1)));
    return hilbert_place(cell, bits_);
  }

 private:
  int bits_;
  glm::dvec3 low_{0.0};
  double cells_per_unit_ = 0;
};

/// Cuts the curve into pieces of about equal numbers of points: from the points in each cell, in
/// the order of the curve, to the piece of each. A cell goes to the piece that the middle of its
/// points falls into.
template <typename Count>
void cut_into_pieces(std::vector<Count>& cells, std::uint64_t points, std::uint64_t pieces) {
  std::uint64_t before = 0;
  for (Count& c : cells) {
    const std::uint64_t middle = before + c / 2;
    before += c;
    c = static_cast<Count>(middle * pieces / std::max<std::uint64_t>(1, points));
  }
}

}  // namespace aomd
