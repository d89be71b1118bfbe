#include "core/fields/tet_coordinates.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include <glm/geometric.hpp>

namespace aomd::fields {
namespace {

/// Where a corner of a piece lies: its coordinates in the tetrahedron that cuts.
using Piece = std::array<Weights, 4>;

/// The place of the cut on the way from a corner inside to one outside.
double place_of_cut(const Weights& in, const Weights& out, std::size_t side) {
  return in[side] / (in[side] - out[side]);
}

Weights between(const Weights& from, const Weights& to, double t) {
  Weights result{};
  for (std::size_t k = 0; k < 4; ++k) result[k] = from[k] + t * (to[k] - from[k]);
  return result;
}

double share_of(const Piece& piece, unsigned sides);

/// The corner `a` of a piece, the others beyond the side.
double share_of_corner(const Piece& p, std::size_t side, unsigned others) {
  Piece tip{p[0], {}, {}, {}};
  double share = 1;
  for (std::size_t k = 1; k < 4; ++k) {
    const double t = place_of_cut(p[0], p[k], side);
    tip[k] = between(p[0], p[k], t);
    share *= t;
  }
  return share > 0 ? share * share_of(tip, others) : 0;
}

/// A wedge as three tetrahedra, by what share of the whole each is.
double share_of_wedge(const std::array<Piece, 3>& tets, const std::array<double, 3>& shares,
                      unsigned others) {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k)
    if (shares[k] > 0) sum += shares[k] * share_of(tets[k], others);
  return sum;
}

/// Two corners on either side: p[0] and p[1] stay.
double share_of_halves(const Piece& p, std::size_t side, unsigned others) {
  const double s = place_of_cut(p[0], p[2], side), t = place_of_cut(p[0], p[3], side),
               u = place_of_cut(p[1], p[2], side), v = place_of_cut(p[1], p[3], side);
  const Weights ac = between(p[0], p[2], s), ad = between(p[0], p[3], t),
                bc = between(p[1], p[2], u), bd = between(p[1], p[3], v);
  return share_of_wedge({{{p[0], ac, ad, p[1]}, {ac, ad, p[1], bd}, {ac, p[1], bc, bd}}},
                        {s * t, s * (1 - t) * v, u * v * (1 - s)}, others);
}

/// p[0] lies beyond the side, the others stay.
double share_without_corner(const Piece& p, std::size_t side, unsigned others) {
  std::array<double, 4> s{};
  Piece cut{};
  for (std::size_t k = 1; k < 4; ++k) {
    s[k] = 1 - place_of_cut(p[k], p[0], side);
    cut[k] = between(p[0], p[k], s[k]);
  }
  return share_of_wedge(
      {{{p[1], p[2], p[3], cut[1]}, {p[2], p[3], cut[1], cut[2]}, {p[3], cut[1], cut[2], cut[3]}}},
      {1 - s[1], s[1] * (1 - s[2]), s[1] * s[2] * (1 - s[3])}, others);
}

/// Two corners of a piece change places; the share does not.
void bring_forward(Piece& piece, std::size_t from, std::size_t to) {
  if (from != to) std::swap(piece[from], piece[to]);
}

/// The share of a piece inside of some sides, one bit each.
double share_of(const Piece& piece, unsigned sides) {
  for (; sides != 0; sides &= sides - 1) {
    const auto side = static_cast<std::size_t>(std::countr_zero(sides));
    const unsigned in = unsigned{piece[0][side] > 0} | unsigned{piece[1][side] > 0} << 1 |
                        unsigned{piece[2][side] > 0} << 2 | unsigned{piece[3][side] > 0} << 3;
    if (in == 15) continue;
    if (in == 0) return 0;
    const int corners = std::popcount(in);
    const unsigned first = corners == 3 ? ~in & 15u : in;  // the one of its kind, or two of a kind
    const unsigned others = sides & (sides - 1);
    Piece sorted = piece;
    bring_forward(sorted, static_cast<std::size_t>(std::countr_zero(first)), 0);
    if (corners == 1) return share_of_corner(sorted, side, others);
    if (corners == 3) return share_without_corner(sorted, side, others);
    bring_forward(sorted, static_cast<std::size_t>(std::bit_width(first)) - 1, 1);
    return share_of_halves(sorted, side, others);
  }
  return 1;
}

}  // namespace

TetCoordinates::TetCoordinates(const Tet& corners)
    : origin_(corners[0]),
      edges_{corners[1] - corners[0], corners[2] - corners[0], corners[3] - corners[0]} {
  const glm::dvec3 normal = glm::cross(edges_[0], edges_[1]);
  const double six_volumes = glm::dot(normal, edges_[2]);
  gradients_ = {glm::cross(edges_[1], edges_[2]) / six_volumes,
                glm::cross(edges_[2], edges_[0]) / six_volumes, normal / six_volumes};
  flat_ = std::any_of(gradients_.begin(), gradients_.end(),
                      [](const glm::dvec3& g) { return !std::isfinite(glm::dot(g, g)); });
}

Weights TetCoordinates::at(const glm::dvec3& p) const {
  const glm::dvec3 s = shares(p - origin_);
  return {1 - s.x - s.y - s.z, s.x, s.y, s.z};
}

Weights TetCoordinates::refined(const glm::dvec3& p) const {
  const glm::dvec3 way = p - origin_;
  glm::dvec3 s = shares(way);
  for (int round = 0; round < 2; ++round)
    s += shares(way - (s.x * edges_[0] + s.y * edges_[1] + s.z * edges_[2]));
  return {1 - s.x - s.y - s.z, s.x, s.y, s.z};
}

glm::dvec3 TetCoordinates::shares(const glm::dvec3& way) const {
  return {glm::dot(gradients_[0], way), glm::dot(gradients_[1], way), glm::dot(gradients_[2], way)};
}

double least(const Weights& weights) { return *std::min_element(weights.begin(), weights.end()); }

// Most tetrahedra near by lie beyond one of the sides: the others are then not looked at. A side
// that has all corners within has all of their pieces too.
double share_inside(const TetCoordinates& inside, const Tet& tet) {
  Piece piece{};
  for (Weights& corner : piece) corner[0] = 1;
  unsigned sides = 0;
  const auto reaches = [&](std::size_t side) {
    const auto [low, high] =
        std::minmax({piece[0][side], piece[1][side], piece[2][side], piece[3][side]});
    sides |= unsigned{!(low > 0)} << side;
    return high > 0;
  };
  for (std::size_t side = 1; side < 4; ++side) {
    for (std::size_t k = 0; k < 4; ++k) {
      piece[k][side] = inside.at(tet[k], side);
      piece[k][0] -= piece[k][side];
    }
    if (!reaches(side)) return 0;
  }
  return reaches(0) ? share_of(piece, sides) : 0;
}

}  // namespace aomd::fields
