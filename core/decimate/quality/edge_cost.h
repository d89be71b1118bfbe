#pragma once
// What the collapse of an edge inside a model face costs, for one edge or for four at once.

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "core/base/lanes.h"
#include "core/decimate/quadric.h"

namespace aomd {

/// What a cost is made of.
struct CostRules {
  float edge_weight = 0;  ///< what a squared edge length costs, by the area it stands for
  float scale = 1;        ///< makes costs independent of the mesh's units
  double unit_area = 1;   ///< areas are counted in it: numbers stay near 1
  bool cubes = true, places = true;  ///< the ideas of these names are in force
};

/// An edge as seen from one of its ends, and what both stand for together.
template <typename Number>
struct EdgeView {
  QuadricOf<Number> quadric;
  glm::vec<3, Number> along;  ///< to the other end
  Number length2, area;
};

/// Where the error is least: not further than its length from the middle of the edge, where the
/// place is if flatness leaves it open.
template <typename Number>
[[nodiscard]] glm::vec<3, Number> place_of_least(const EdgeView<Number>& edge) {
  const Number steady(1e-3f);  // of the quadric's trace: flat places leave the minimum open else
  const glm::vec<3, Number> middle = Number(0.5f) * edge.along;
  glm::vec<3, Number> x;
  const auto found = edge.quadric.minimum(middle, steady * edge.quadric.trace(), x);
  const glm::vec<3, Number> off = x - middle;
  const auto near = glm::dot(off, off) <= Number(4.0f) * edge.length2;
  const auto which = found & near;
  return {select(which, x.x, middle.x), select(which, x.y, middle.y), select(which, x.z, middle.z)};
}

/// Squared distances become third powers, nearly: few large errors count more than many small ones.
template <typename Number>
[[nodiscard]] Number price(const CostRules& rules, Number squares, Number area) {
  // Of the distance, by the diagonal, whose third power is as large as its square.
  constexpr float inverse_typical = 1e3f;
  using std::sqrt;
  const Number zero(0.0f), scaled = squares * Number(rules.scale);
  const Number positive = select(zero < scaled, scaled, zero);
  if (!rules.cubes) return positive;
  const Number cubed = positive * sqrt(positive / area) * Number(inverse_typical);
  return select(area > zero, cubed, positive);
}

/// What it costs to put both ends at a place.
template <typename Number>
[[nodiscard]] Number cost_at(const CostRules& rules, const EdgeView<Number>& edge,
                             const glm::vec<3, Number>& x) {
  return price(rules, edge.quadric(x), edge.area) +
         Number(rules.edge_weight) * edge.area * edge.length2 * Number(rules.scale);
}

/// What the numbers beside the shape add. No third power: an error of theirs is at most their
/// range.
template <typename Number>
[[nodiscard]] Number cost_beside(const CostRules& rules, const QuadricOf<Number>& quadric,
                                 const glm::vec<3, Number>& x) {
  const Number zero(0.0f), squares = quadric(x);
  return Number(rules.scale) * select(zero < squares, squares, zero);
}

}  // namespace aomd
