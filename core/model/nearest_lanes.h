#pragma once
// The place on a triangle nearest to a point, for several triangles or points at once.

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "core/base/lanes.h"

namespace aomd {

/// What nearest_barycentric() (core/model/triangle_tree.h) says, lane by lane and bit by bit,
/// without a branch: all cases are computed, from the last to the first.
template <typename Number>
[[nodiscard]] LanesOf<Number> nearest_barycentric(const glm::vec<3, LanesOf<Number>>& p,
                                                  const glm::vec<3, LanesOf<Number>>& a,
                                                  const glm::vec<3, LanesOf<Number>>& b,
                                                  const glm::vec<3, LanesOf<Number>>& c,
                                                  glm::vec<3, LanesOf<Number>>& barycentric) {
  using N = LanesOf<Number>;
  const N zero(Number(0)), one(Number(1));
  const auto ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
  const N d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap), d3 = glm::dot(ab, bp),
          d4 = glm::dot(ac, bp), d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
  const N va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6, vc = d1 * d4 - d3 * d2;
  N z = (d4 - d3) / ((d4 - d3) + (d5 - d6)), y = one - z;  // on the side between b and c
  const auto where = [&](auto which, N to_y, N to_z) {
    y = select(which, to_y, y);
    z = select(which, to_z, z);
  };
  where((vb <= zero) & (d2 >= zero) & (d6 <= zero) & (d2 > d6), zero, d2 / (d2 - d6));
  where((vc <= zero) & (d1 >= zero) & (d3 <= zero) & (d1 > d3), d1 / (d1 - d3), zero);
  where((d6 >= zero) & (d5 <= d6), zero, one);
  where((d3 >= zero) & (d4 <= d3), one, zero);
  where((d1 <= zero) & (d2 <= zero), zero, zero);
  const N sum = va + vb + vc;
  where((va > zero) & (vb > zero) & (vc > zero), vb / sum, vc / sum);
  const auto on_side = (z == one) | (y == one) | (y + z == one);
  barycentric = {select(on_side, zero, one - y - z), y, z};
  const auto d = ap - y * ab - z * ac;
  return glm::dot(d, d);
}

}  // namespace aomd
