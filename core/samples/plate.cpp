#include "core/samples/plate.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace aomd::sample {
namespace {

using Index = std::uint32_t;

class PlateBuilder {
 public:
  PlateBuilder(int width, int height, int n, std::span<const Hole> holes)
      : n_(n), columns_(width * n), rows_(height * n), holes_(holes) {
    lattice_.assign(static_cast<std::size_t>(columns_ + 1) * static_cast<std::size_t>(rows_ + 1),
                    none);
  }

  Plate build() {
    for (int j = 0; j < rows_; ++j) {
      for (int i = 0; i < columns_; ++i) {
        if (in_block(i, j)) continue;
        const Index quad[4] = {lattice(i, j), lattice(i + 1, j), lattice(i + 1, j + 1),
                               lattice(i, j + 1)};
        cut(quad, (i + j) % 2 == 1);
      }
    }
    for (std::size_t h = 0; h < holes_.size(); ++h) rings(static_cast<int>(h));
    return std::move(plate_);
  }

 private:
  static constexpr Index none = 0xffffffffu;

  Index add(const glm::dvec2& p, int hole) {
    plate_.points.push_back(p);
    plate_.hole_of.push_back(hole);
    return static_cast<Index>(plate_.points.size() - 1);
  }

  Index lattice(int i, int j) {
    Index& slot = lattice_[static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_ + 1) +
                           static_cast<std::size_t>(i)];
    if (slot == none) slot = add({static_cast<double>(i) / n_, static_cast<double>(j) / n_}, -1);
    return slot;
  }

  [[nodiscard]] bool in_block(int i, int j) const {
    return std::any_of(holes_.begin(), holes_.end(), [&](const Hole& h) {
      return i >= (h.x - 1) * n_ && i < (h.x + 1) * n_ && j >= (h.y - 1) * n_ && j < (h.y + 1) * n_;
    });
  }

  void cut(const Index (&q)[4], bool other_diagonal) {
    const std::size_t s = other_diagonal ? 1 : 0;
    plate_.triangles.push_back({q[s], q[s + 1], q[(s + 2) % 4]});
    plate_.triangles.push_back({q[s], q[(s + 2) % 4], q[(s + 3) % 4]});
  }

  /// The lattice points around a block, counter-clockwise.
  std::vector<Index> block_rim(const Hole& h) {
    const int left = (h.x - 1) * n_, right = (h.x + 1) * n_, low = (h.y - 1) * n_,
              high = (h.y + 1) * n_;
    std::vector<Index> rim;
    for (int i = left; i < right; ++i) rim.push_back(lattice(i, low));
    for (int j = low; j < high; ++j) rim.push_back(lattice(right, j));
    for (int i = right; i > left; --i) rim.push_back(lattice(i, high));
    for (int j = high; j > low; --j) rim.push_back(lattice(left, j));
    return rim;
  }

  void rings(int hole) {
    const Hole& h = holes_[static_cast<std::size_t>(hole)];
    const glm::dvec2 center(h.x, h.y);
    const std::vector<Index> rim = block_rim(h);
    const int layers = std::max(1, static_cast<int>(std::lround(n_ * (1.2 - h.radius))));
    std::vector<Index> inner(rim.size()), outer;
    for (int layer = 0; layer <= layers; ++layer, inner.swap(outer)) {
      outer.resize(rim.size());
      for (std::size_t k = 0; k < rim.size(); ++k) {
        const glm::dvec2 end = plate_.points[rim[k]],
                         start = center + h.radius * glm::normalize(end - center);
        const double t = static_cast<double>(layer) / layers;
        outer[k] = layer == layers ? rim[k] : add(glm::mix(start, end, t), layer == 0 ? hole : -1);
      }
      for (std::size_t k = 0; layer > 0 && k < rim.size(); ++k) {
        const std::size_t next = (k + 1) % rim.size();
        const Index quad[4] = {inner[k], outer[k], outer[next], inner[next]};
        cut(quad, glm::distance(plate_.points[quad[1]], plate_.points[quad[3]]) <
                      0.999999 * glm::distance(plate_.points[quad[0]], plate_.points[quad[2]]));
      }
    }
  }

  int n_, columns_, rows_;
  std::span<const Hole> holes_;
  std::vector<Index> lattice_;
  Plate plate_;
};

}  // namespace

Plate make_plate(int width, int height, int n, std::span<const Hole> holes) {
  return PlateBuilder(width, height, n, holes).build();
}

}  // namespace aomd::sample
