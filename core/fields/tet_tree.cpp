#include "core/fields/tet_tree.h"

#include <algorithm>
#include <cmath>

namespace aomd::fields {

TetTree::TetTree(const Cells& regions, const std::vector<std::uint32_t>& cells, int threads) {
  std::vector<BoxTree::Item> items;
  items.reserve(cells.size());
  for (const std::uint32_t r : cells) items.push_back({regions.centre(r), r});
  boxes_ = BoxTree(items, threads);
  std::vector<Box> boxes;
  boxes.reserve(cells.size());
  tets_.reserve(cells.size());
  volumes_.reserve(cells.size());
  cells_.reserve(cells.size());
  for (std::uint32_t n = 0; n < boxes_.size(); ++n) {
    cells_.push_back(boxes_.source(n));
    tets_.push_back(regions.tet(cells_[n]));
    volumes_.push_back(regions.measure(cells_[n]));
    boxes.push_back(box_of(tets_[n]));
    size_ += boxes[n].diagonal() / static_cast<double>(cells.size());
  }
  boxes_.fit(std::move(boxes));
}

void TetTree::look(const glm::dvec3& p, double radius, Best& best) const {
  const glm::dvec3 reach(radius);
  boxes_.touching({p - reach, p + reach}, [&](std::uint32_t n) {
    const TetCoordinates coordinates(tets_[n]);
    if (coordinates.flat()) return;
    const double inside = least(coordinates.at(p));
    if (inside > best.inside) best = {cells_[n], inside};
  });
}

std::uint32_t TetTree::region_at(const glm::dvec3& p) const {
  constexpr double close_enough = -0.25;
  Best best;
  look(p, 0, best);
  if (best.inside >= 0) return best.region;
  const double most = boxes_.box().diagonal() + std::sqrt(boxes_.box().distance2(p));
  for (double radius = std::max(size_, 1e-6 * most) / 64;
       best.inside < close_enough && radius < 4 * most; radius *= 4)
    look(p, radius, best);
  return best.region;
}

}  // namespace aomd::fields
