#include "core/decimate/guard/covered_cells.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <glm/geometric.hpp>

#include "core/decimate/guard/overlay.h"
#include "core/decimate/guard/triangle_cuts.h"

namespace aomd {
namespace {

double distance2(const Triangle& cell, const glm::dvec3& p) {
  const glm::dvec3 d = nearest_point(cell, p) - p;
  return glm::dot(d, d);
}

double distance2(const Triangle& cell, const Triangle& part) {
  return std::max({distance2(cell, part[0]), distance2(cell, part[1]), distance2(cell, part[2])});
}

glm::dvec3 centre(const Triangle& t) { return (t[0] + t[1] + t[2]) / 3.0; }

/// The cells on each model entity, in a tree.
class CellTrees {
 public:
  explicit CellTrees(std::span<const ModelCell> cells) {
    std::map<ModelRef, std::vector<Triangle>> corners;
    for (const ModelCell& cell : cells) {
      ids_[cell.model].push_back(cell.id);
      corners[cell.model].push_back(cell.corners);
    }
    for (auto& [model, triangles] : corners) trees_.emplace(model, std::move(triangles));
  }

  [[nodiscard]] std::uint32_t nearest(ModelRef model, const glm::dvec3& p) const {
    const auto tree = trees_.find(model);
    if (tree == trees_.end()) return no_index;
    return ids_.at(model)[tree->second.source(tree->second.nearest(p).triangle)];
  }

 private:
  std::map<ModelRef, std::vector<std::uint32_t>> ids_;
  std::map<ModelRef, TriangleTree> trees_;
};

TriangleParts cut(const Triangle& part, const Triangle& cell, double centre2, double most2) {
  const double out = 0.5 * std::sqrt(most2 - centre2);
  const TriangleParts parts = cut_along_sides(part, cell, out, 0.01 * std::sqrt(most2));
  return parts.count > 0 ? parts : bisected(part);
}

}  // namespace

CoveredCells::CoveredCells(const std::vector<ModelCell>& originals, double distance)
    : distance_(distance) {
  originals_.reserve(originals.size());
  for (const ModelCell& cell : originals) {
    put(cell);
    originals_.push_back({cell.corners, cell.model});
    join(static_cast<std::uint32_t>(originals_.size() - 1), {cell.id, nullptr, {}}, 0);
  }
}

void CoveredCells::put(const ModelCell& cell) {
  if (cell.id >= cells_.size()) cells_.resize(cell.id + std::size_t{1});
  cells_[cell.id].corners = cell.corners;
}

void CoveredCells::link(std::uint32_t& first, std::uint32_t to) {
  if (free_ == no_index) {
    free_ = static_cast<std::uint32_t>(links_.size());
    links_.push_back({to, no_index});
  }
  const std::uint32_t id = std::exchange(free_, links_[free_].next);
  links_[id] = {to, std::exchange(first, id)};
}

void CoveredCells::unlink(std::uint32_t& first) {
  while (first != no_index) {
    const std::uint32_t id = std::exchange(first, links_[first].next);
    links_[id].next = std::exchange(free_, id);
  }
}

void CoveredCells::join(std::uint32_t original, const Candidate& cell, double distance2) {
  Original& o = originals_[original];
  o.distance2 = std::max(o.distance2, distance2);
  for (std::uint32_t l = o.near; l != no_index; l = links_[l].next)
    if (links_[l].to == cell.id) return;
  link(o.near, cell.id);
  if (!cell.linked) link(cells_[cell.id].stands_for, original);
}

double CoveredCells::reach2(const Original& original) const {
  return std::max(distance_ * distance_, original.distance2);
}

// By the cells that are over it along its normal, if they are over all of it and high enough for
// none of its points to be out of reach: what most are.
bool CoveredCells::laid_over(const Triangle& original, double most2) {
  Overlay overlay(original, most2);
  over_.clear();
  Box within_reach = box_of(original);
  within_reach.low -= std::sqrt(most2), within_reach.high += std::sqrt(most2);
  for (const Candidate& c : candidates_) {
    if (!c.box.touches(within_reach)) continue;
    if (const double height2 = overlay.lay(*c.corners); height2 >= 0)
      over_.push_back({&c, 0, height2});
  }
  return overlay.complete();
}

// Hands each part and the cell that it is near to take(), which says whether to go on; what is near
// none comes with the one it is nearest to, if there is one.
template <typename Find, typename Take>
void CoveredCells::cover(const Triangle& original, double most2, const Find& find,
                         const Take& take) {
  parts_.assign({original});
  for (int seen = 1; !parts_.empty(); ++seen) {
    const Triangle part = parts_.back();
    parts_.pop_back();
    const Nearest n = find(part);
    const bool last = n.of_centre2 > most2 || seen > most_parts ||
                      longest_side2(part) <= least_part * least_part * most2;
    if (last || n.of_part2 <= most2) {
      if (!take(part, n)) return;
      continue;
    }
    const TriangleParts smaller = cut(part, *n.cell->corners, n.of_centre2, most2);
    parts_.insert(parts_.end(), smaller.span().begin(), smaller.span().end());
  }
}

void CoveredCells::attach(std::span<const ModelCell> cells) {
  const CellTrees trees(cells);
  cells_.clear(), links_.clear();
  free_ = no_index;
  for (const ModelCell& cell : cells) put(cell);
  for (std::uint32_t i = 0; i < originals_.size(); ++i) {
    Original& original = originals_[i];
    original.near = no_index, original.distance2 = 0;
    Candidate found;
    const auto find = [&](const Triangle& part) -> Nearest {
      const std::uint32_t id = trees.nearest(original.model, centre(part));
      if (id == no_index) return {};
      found = {id, &cells_[id].corners, {}};
      return {&found, distance2(*found.corners, centre(part)), distance2(*found.corners, part)};
    };
    cover(original.corners, reach2(original), find, [&](const Triangle&, const Nearest& n) {
      if (n.cell) join(i, *n.cell, n.of_part2);
      return true;
    });
  }
}

void CoveredCells::gather(std::span<const std::uint32_t> replaced) {
  gathered_.clear();
  ++stamp_;
  for (const std::uint32_t id : replaced) {
    if (id >= cells_.size()) continue;
    for (std::uint32_t l = cells_[id].stands_for; l != no_index; l = links_[l].next)
      if (std::exchange(originals_[links_[l].to].stamp, stamp_) != stamp_)
        gathered_.push_back(links_[l].to);
  }
}

void CoveredCells::choose(ModelRef model, std::span<const ModelCell> cells) {
  candidates_.clear();
  model_ = model;
  for (const ModelCell& cell : cells)
    if (cell.model == model) candidates_.push_back({cell.id, &cell.corners, box_of(cell.corners)});
  on_model_ = candidates_.size();
}

// Those of `cells` on the same model entity, and the others that the original is near and that stay
// as they are.
void CoveredCells::choose(const Original& original, std::span<const std::uint32_t> replaced,
                          std::span<const ModelCell> cells) {
  if (original.model != model_) choose(original.model, cells);
  candidates_.resize(on_model_);
  for (Candidate& c : candidates_) c.linked = false;
  for (std::uint32_t l = original.near; l != no_index; l = links_[l].next) {
    const std::uint32_t id = links_[l].to;
    if (std::find(replaced.begin(), replaced.end(), id) != replaced.end()) continue;
    const auto known = std::find_if(candidates_.begin(), candidates_.end(),
                                    [&](const Candidate& c) { return c.id == id; });
    if (known != candidates_.end())
      known->linked = true;
    else
      candidates_.push_back({id, &cells_[id].corners, box_of(cells_[id].corners), true});
  }
}

// The one that was hinted at, if all of the part is near it; else the one nearest to the centre, or
// another one that all of the part is near.
CoveredCells::Nearest CoveredCells::nearest(const Triangle& part, double most2,
                                            std::size_t hint) const {
  const auto holds = [&](const Candidate& c) {
    return std::all_of(part.begin(), part.end(), [&](const glm::dvec3& p) {
      return c.box.distance2(p) <= most2 && distance2(*c.corners, p) <= most2;
    });
  };

  if (hint < candidates_.size() && holds(candidates_[hint])) return {&candidates_[hint], 0, 0};
  const glm::dvec3 middle = centre(part);
  Nearest best;
  for (const Candidate& c : candidates_) {
    if (c.box.distance2(middle) >= best.of_centre2) continue;
    if (const double d2 = distance2(*c.corners, middle); d2 < best.of_centre2) best = {&c, d2};
  }
  if (!best.cell) return best;
  best.of_part2 = distance2(*best.cell->corners, part);
  if (best.of_part2 <= most2 || best.of_centre2 > most2) return best;
  for (const Candidate& c : candidates_)
    if (holds(c)) return {&c, 0, distance2(*c.corners, part)};
  return best;
}

// Of the corners and the centre, to the nearest candidate.
double CoveredCells::furthest2(const Triangle& part) const {
  double most2 = 0;
  for (const glm::dvec3& p : {part[0], part[1], part[2], centre(part)}) {
    double least2 = std::numeric_limits<double>::infinity();
    for (const Candidate& c : candidates_) least2 = std::min(least2, distance2(*c.corners, p));
    most2 = std::max(most2, least2);
  }
  return most2;
}

double CoveredCells::uncovered(std::span<const std::uint32_t> replaced,
                               std::span<const ModelCell> cells) {
  gather(replaced);
  choose(ModelRef(), cells);
  std::size_t hint = 0;
  for (const std::uint32_t i : gathered_) {
    const Original& original = originals_[i];
    const double most2 = reach2(original);
    double far2 = 0;
    choose(original, replaced, cells);
    if (laid_over(original.corners, most2)) continue;
    const auto find = [&](const Triangle& part) { return nearest(part, most2, hint); };
    cover(original.corners, most2, find, [&](const Triangle& part, const Nearest& n) {
      hint = n.cell ? static_cast<std::size_t>(n.cell - candidates_.data()) : 0;
      if (n.of_part2 > most2) far2 = std::max(furthest2(original.corners), furthest2(part));
      return far2 == 0;
    });
    if (far2 > 0) return std::sqrt(far2);
  }
  return 0;
}

void CoveredCells::hand_over(std::span<const std::uint32_t> replaced,
                             std::span<const ModelCell> cells) {
  gather(replaced);
  for (const std::uint32_t id : replaced)
    if (id < cells_.size()) unlink(cells_[id].stands_for);
  for (const ModelCell& cell : cells) put(cell);
  choose(ModelRef(), cells);
  for (const std::uint32_t i : gathered_) {
    Original& original = originals_[i];
    const double most2 = reach2(original);
    choose(original, replaced, cells);
    unlink(original.near);
    original.distance2 = 0;
    if (laid_over(original.corners, most2)) {
      for (const Nearest& n : over_) join(i, *n.cell, n.of_part2);
      continue;
    }
    const auto find = [&](const Triangle& part) { return nearest(part, most2, no_index); };
    cover(original.corners, most2, find, [&](const Triangle&, const Nearest& n) {
      if (n.cell) join(i, *n.cell, n.of_part2);
      return true;
    });
  }
}

}  // namespace aomd
