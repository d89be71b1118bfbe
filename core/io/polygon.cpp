#include "core/io/polygon.h"

#include <algorithm>
#include <cmath>
#include <deque>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace aomd::io::detail {
namespace {

using Index = std::uint32_t;
using Positions = std::span<const glm::dvec3>;

/// The polygon's normal by Newell's sum, relative to its first vertex so that far-away polygons
/// keep digits.
glm::dvec3 newell_normal(Positions positions, std::span<const Index> polygon) {
  glm::dvec3 sum(0);
  const glm::dvec3 origin = positions[polygon[0]];
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    sum += glm::cross(positions[polygon[i]] - origin, positions[polygon[i + 1]] - origin);
  }
  return sum;
}

/// How well the split of a quad along corners (i, i+2) keeps both halves on the side of `normal`:
/// their smaller area, signed.
double worse_half(Positions p, std::span<const Index> q, std::size_t i, const glm::dvec3& normal) {
  const glm::dvec3 &a = p[q[i]], &b = p[q[i + 1]], &c = p[q[(i + 2) % 4]], &d = p[q[(i + 3) % 4]];
  const glm::dvec3 diagonal = c - a;
  return std::min(glm::dot(glm::cross(b - a, diagonal), normal),
                  glm::dot(glm::cross(diagonal, d - a), normal));
}

void split_quad(Positions p, std::span<const Index> q, std::vector<Index>& out) {
  const glm::dvec3 normal = newell_normal(p, q);
  const double half02 = worse_half(p, q, 0, normal), half13 = worse_half(p, q, 1, normal);
  const bool sound02 = half02 > 0, sound13 = half13 > 0;
  bool use02 = half02 >= half13;
  if (sound02 == sound13)
    use02 = glm::distance(p[q[0]], p[q[2]]) <= glm::distance(p[q[1]], p[q[3]]);
  if (use02) {
    out.insert(out.end(), {q[0], q[1], q[2], q[0], q[2], q[3]});
  } else {
    out.insert(out.end(), {q[0], q[1], q[3], q[1], q[2], q[3]});
  }
}

double cross2(const glm::dvec2& o, const glm::dvec2& a, const glm::dvec2& b) {
  return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
}

/// The corners in the coordinate plane that shows the polygon largest, turned so that it runs
/// counter-clockwise.
std::vector<glm::dvec2> flatten(Positions positions, std::span<const Index> polygon) {
  const glm::dvec3 normal = newell_normal(positions, polygon);
  int drop = 0;
  for (int axis = 1; axis < 3; ++axis) {
    if (std::abs(normal[axis]) > std::abs(normal[drop])) drop = axis;
  }
  int u = (drop + 1) % 3, v = (drop + 2) % 3;
  if (normal[drop] < 0) std::swap(u, v);
  std::vector<glm::dvec2> flat;
  flat.reserve(polygon.size());
  for (const Index i : polygon) flat.emplace_back(positions[i][u], positions[i][v]);
  return flat;
}

/// Ear clipping on a linked ring of corners. Only corners that are not convex can lie in an ear,
/// and cutting one off changes whether its two neighbours are ears, nothing else.
class EarClipper {
 public:
  EarClipper(std::vector<glm::dvec2> corners, std::span<const Index> polygon,
             std::vector<Index>& out)
      : p_(std::move(corners)),
        polygon_(polygon),
        out_(out),
        next_(p_.size()),
        previous_(p_.size()) {
    for (std::size_t i = 0; i < p_.size(); ++i) {
      next_[i] = (i + 1) % p_.size();
      previous_[next_[i]] = i;
    }
    for (std::size_t i = 0; i < p_.size(); ++i) {
      if (turn(i) <= 0) blockers_.push_back(i);
    }
  }

  void run() {
    for (std::size_t i = 0; i < p_.size(); ++i) ears_.push_back(i);
    std::size_t anywhere = 0;
    for (std::size_t remaining = p_.size(); remaining > 3; --remaining) {
      std::size_t tip = find_ear();
      if (tip == none) tip = anywhere;  // the polygon crosses itself or is flat
      anywhere = cut(tip);
    }
    emit(anywhere);
  }

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  [[nodiscard]] bool cut_off(std::size_t i) const { return next_[i] == none; }
  [[nodiscard]] double turn(std::size_t i) const {
    return cross2(p_[previous_[i]], p_[i], p_[next_[i]]);
  }

  /// Takes candidates first in, first out, which spreads the cuts around the ring.
  std::size_t find_ear() {
    while (!ears_.empty()) {
      const std::size_t i = ears_.front();
      ears_.pop_front();
      if (!cut_off(i) && is_ear(i)) return i;
    }
    return none;
  }

  bool is_ear(std::size_t i) {
    if (turn(i) <= 0) return false;
    std::erase_if(blockers_, [&](std::size_t b) { return cut_off(b) || turn(b) > 0; });
    const glm::dvec2 &a = p_[previous_[i]], &b = p_[i], &c = p_[next_[i]];
    return std::none_of(blockers_.begin(), blockers_.end(), [&](std::size_t k) {
      const glm::dvec2& q = p_[k];
      const bool corner = q == a || q == b || q == c;
      return !corner && cross2(a, b, q) >= 0 && cross2(b, c, q) >= 0 && cross2(c, a, q) >= 0;
    });
  }

  /// Cuts corner i off and returns a corner that remains.
  std::size_t cut(std::size_t i) {
    emit(i);
    const std::size_t before = previous_[i], after = next_[i];
    next_[before] = after;
    previous_[after] = before;
    next_[i] = none;
    ears_.push_back(before);
    ears_.push_back(after);
    return after;
  }

  void emit(std::size_t i) {
    out_.insert(out_.end(), {polygon_[previous_[i]], polygon_[i], polygon_[next_[i]]});
  }

  std::vector<glm::dvec2> p_;
  std::span<const Index> polygon_;
  std::vector<Index>& out_;
  std::vector<std::size_t> next_, previous_, blockers_;
  std::deque<std::size_t> ears_;
};

}  // namespace

void triangulate(std::span<const glm::dvec3> positions, std::span<const std::uint32_t> polygon,
                 std::vector<std::uint32_t>& out) {
  if (polygon.size() == 3) {
    out.insert(out.end(), polygon.begin(), polygon.end());
  } else if (polygon.size() == 4) {
    split_quad(positions, polygon, out);
  } else {
    EarClipper(flatten(positions, polygon), polygon, out).run();
  }
}

}  // namespace aomd::io::detail
